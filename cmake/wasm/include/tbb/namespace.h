#pragma once
/// oneTBB's two names of its namespace.
namespace tbb {}
namespace oneapi {
namespace tbb = ::tbb;
}
