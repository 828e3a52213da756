// Exceptions of every kind, thrown, caught and thrown again: what it prints is the same whoever compiles it.
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace {

struct Told {
  explicit Told(const char* name) : name(name) {}
  ~Told() { std::printf("~%s\n", name); }
  const char* name;
};

struct Left {
  virtual ~Left() = default;
  int left = 1;
};
struct Right {
  virtual ~Right() = default;
  int right = 2;
};
struct Both : Left, Right {};

struct Counted : std::runtime_error {
  static inline int alive = 0;
  Counted() : std::runtime_error("counted") { ++alive; }
  Counted(const Counted& other) : std::runtime_error(other) { ++alive; }
  ~Counted() override { --alive; }
};

[[gnu::noinline]] void throw_one(int kind) {
  const Told told("throw_one");
  switch (kind) {
    case 0:
      throw Counted();
    case 1:
      throw Both();
    case 2:
      throw 7;
    case 3:
      throw std::string("a text");
    case 4:
      throw static_cast<const char*>("an address");
    case 5:
      throw &throw_one;
    default:
      break;
  }
}

[[gnu::noinline]] void pass_on(int kind) {
  const Told told("pass_on");
  try {
    throw_one(kind);
  } catch (const std::runtime_error& error) {
    std::printf("passed on: %s\n", error.what());
    throw;
  } catch (const std::string& text) {
    std::printf("another for %s\n", text.c_str());
    throw std::logic_error("another");
  }
}

void catch_each() {
  for (int kind = 0; kind < 7; ++kind) try {
      std::printf("kind %d\n", kind);
      pass_on(kind);
    } catch (Right& right) {
      std::printf("right %d\n", right.right);
    } catch (const std::exception& error) {
      std::printf("an exception: %s\n", error.what());
    } catch (const void* address) {
      std::printf("an address: %s\n", static_cast<const char*>(address));
    } catch (...) {
      std::printf("something\n");
    }
}

// An exception that is in flight or caught at several places, by pointers and by `throw`.
void throw_again() {
  std::exception_ptr kept;
  try {
    throw Counted();
  } catch (Counted&) {
    kept = std::current_exception();
    try {
      throw 1;
    } catch (int) {
      try {
        std::rethrow_exception(kept);
      } catch (Counted&) {
        try {
          std::rethrow_exception(kept);
        } catch (Counted&) {
          try {
            throw;
          } catch (Counted&) {
            std::printf("thrown three times, %s\n",
                        kept == std::current_exception() ? "one exception" : "two exceptions");
          }
        }
      }
      try {
        throw;
      } catch (int number) {
        std::printf("the number %d again\n", number);
      }
    }
    try {
      throw;
    } catch (Counted&) {
      std::printf("alive %d, uncaught %d\n", Counted::alive, std::uncaught_exceptions());
    }
  }
  for (int i = 0; i < 1000; ++i) try {
      std::rethrow_exception(kept);
    } catch (const Counted&) {
    }
  kept = nullptr;
  std::printf("alive %d, uncaught %d\n", Counted::alive, std::uncaught_exceptions());
}

struct Throwing {
  ~Throwing() {
    try {
      throw 1;
    } catch (int) {
      std::printf("in a destructor, uncaught %d\n", std::uncaught_exceptions());
    }
  }
};

}  // namespace

int main() {
  catch_each();
  throw_again();
  try {
    const Throwing throwing;
    throw 2;
  } catch (int number) {
    std::printf("number %d\n", number);
  }
  volatile std::size_t much = ~std::size_t{0} / 8 * 7;  // more than any machine has
  try {
    ::operator delete(::operator new(much));
    std::printf("much memory\n");
  } catch (const std::bad_alloc&) {
    std::printf("no memory\n");
  }
  std::printf("alive %d, uncaught %d\n", Counted::alive, std::uncaught_exceptions());
}
