#pragma once
/// oneTBB gives its headers two names.
#include "tbb/parallel_for.h"
