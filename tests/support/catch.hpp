#pragma once
/// Catch2 under one name: the sources compile with version 2 (Debian 12) and with version 3.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif
