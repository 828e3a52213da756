#pragma once
/// oneTBB gives its headers two names.
#include "tbb/partitioner.h"
