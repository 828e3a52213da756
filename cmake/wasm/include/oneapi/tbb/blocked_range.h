#pragma once
/// oneTBB gives its headers two names.
#include "tbb/blocked_range.h"
