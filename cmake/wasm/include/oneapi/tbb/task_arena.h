#pragma once
/// oneTBB gives its headers two names.
#include "tbb/task_arena.h"
