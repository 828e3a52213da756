// Exceptions for the build as WebAssembly. Debian's libc++abi for WebAssembly is compiled without them: it has the
// types that a handler is matched by, and no function that throws or catches. These are the missing ones, by the
// Itanium C++ ABI and by what Clang calls for -fwasm-exceptions. One thread is assumed, as everywhere in this build.
#include <cxxabi.h>
#include <unwind.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <typeinfo>

namespace __cxxabiv1 {

// The base of every type's description in libc++abi, of which a handler's type answers whether it catches another.
class __attribute__((visibility("hidden"))) __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

}  // namespace __cxxabiv1

namespace {

using Destroy = void* (*)(void*);  // WebAssembly checks a call's type, and a destructor returns its object there

/// The header before each thrown object, and one for each time that an exception pointer throws it again.
struct Header {
  const std::type_info* type;
  Destroy destroy;
  void* object;
  Header* first;           ///< whose object it is; null where it is its own
  std::size_t references;  ///< exception pointers, and the flight with its handlers
  int handlers;            ///< that hold it now; negative while one of them throws it again
  Header* next;            ///< caught before this one and not yet ended
  void* adjusted;          ///< the object as the handler's type sees it
  _Unwind_Exception unwind;
};

Header* caught = nullptr;
unsigned uncaught = 0;

// The object stands behind its header, aligned as malloc aligns.
constexpr std::size_t alignment = alignof(std::max_align_t);
constexpr std::size_t header_size = (sizeof(Header) + alignment - 1) / alignment * alignment;

Header* header_of(void* object) { return reinterpret_cast<Header*>(static_cast<char*>(object) - header_size); }
Header* header_of_unwind(void* unwind) {
  return reinterpret_cast<Header*>(static_cast<char*>(unwind) - offsetof(Header, unwind));
}

Header* new_header(std::size_t size_of_object) {
  auto* const header = static_cast<Header*>(std::malloc(header_size + size_of_object));
  if (!header) std::terminate();
  std::memset(static_cast<void*>(header), 0, header_size);
  header->references = 1;
  return header;
}

void release(Header* header) {
  if (--header->references > 0) return;
  if (header->first) {
    release(header->first);
  } else if (header->destroy) {
    header->destroy(header->object);
  }
  std::free(header);
}

[[noreturn]] void raise(Header* header) {
  ++uncaught;
  __builtin_wasm_throw(0, &header->unwind);
}

// The tables that Clang writes for a function with handlers: for each place where an exception lands, a chain of
// actions; for each action, a handler's type, counted backwards from the end of the table of types.
using Byte = std::uint8_t;

std::uint32_t unsigned_leb(const Byte*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const Byte byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    if (!(byte & 0x80)) return value;
  }
}

std::int32_t signed_leb(const Byte*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;;) {
    const Byte byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    shift += 7;
    if (byte & 0x80) continue;
    if (byte & 0x40 && shift < 32) value |= ~std::uint32_t{0} << shift;
    return static_cast<std::int32_t>(value);
  }
}

constexpr Byte omitted = 0xff;  // DW_EH_PE_omit
constexpr Byte absolute = 0;    // DW_EH_PE_absptr, the one form that Clang writes for WebAssembly
constexpr Byte leb = 1;         // DW_EH_PE_uleb128

struct Table {
  const Byte* sites;
  const Byte* actions;
  const Byte* types_end;
};

Table read_table(const Byte* at) {
  if (*at++ != omitted) std::abort();  // the function's start is nowhere needed
  const Byte types = *at++;
  if (types != absolute && types != omitted) std::abort();
  const Byte* types_end = nullptr;
  if (types != omitted) {
    const std::uint32_t offset = unsigned_leb(at);
    types_end = at + offset;
  }
  if (*at++ != leb) std::abort();
  const std::uint32_t length = unsigned_leb(at);
  return {at, at + length, types_end};
}

const std::type_info* type_at(const Table& table, std::int32_t index) {
  const std::type_info* type = nullptr;
  std::memcpy(&type, table.types_end - static_cast<std::size_t>(index) * sizeof type, sizeof type);
  return type;
}

bool catches(const std::type_info* handler, Header* thrown) {
  void* object = thrown->object;
  if (handler) {  // a null pointer is `...`
    const auto* const by = static_cast<const __cxxabiv1::__shim_type_info*>(handler);
    if (!by->can_catch(static_cast<const __cxxabiv1::__shim_type_info*>(thrown->type), object)) return false;
  }
  thrown->adjusted = object;
  return true;
}

// The number of the handler that takes the exception at that place, or 0.
std::int32_t selected(const Byte* description, std::uint32_t place, Header* thrown) {
  const Table table = read_table(description);
  const Byte* site = table.sites;
  for (std::uint32_t i = 0; i < place; ++i) {
    unsigned_leb(site);
    unsigned_leb(site);
  }
  unsigned_leb(site);
  const std::uint32_t first = unsigned_leb(site);
  if (first == 0) return 0;
  for (const Byte* action = table.actions + (first - 1);;) {
    const std::int32_t index = signed_leb(action);
    const Byte* const here = action;
    const std::int32_t further = signed_leb(action);
    if (index < 0) std::abort();  // lists of what a function may throw are no part of C++20
    if (index > 0 && catches(type_at(table, index), thrown)) return index;
    if (further == 0) return 0;
    action = here + further;
  }
}

}  // namespace

extern "C" {

/// A function with handlers leaves its place here, and finds its choice; the name and the order of fields are Clang's.
struct LandingPad {
  std::uintptr_t place;
  std::uintptr_t description;
  std::uintptr_t selector;
};
thread_local LandingPad __wasm_lpad_context;

_Unwind_Reason_Code _Unwind_CallPersonality(void* exception) {
  const auto* const description = reinterpret_cast<const Byte*>(__wasm_lpad_context.description);
  __wasm_lpad_context.selector =
      static_cast<std::uintptr_t>(selected(description, __wasm_lpad_context.place, header_of_unwind(exception)));
  return _URC_NO_REASON;
}

void _Unwind_DeleteException(_Unwind_Exception* exception) { release(header_of_unwind(exception)); }

void* __cxa_allocate_exception(std::size_t size) noexcept {
  Header* const header = new_header(size);
  return header->object = reinterpret_cast<char*>(header) + header_size;
}

void __cxa_free_exception(void* object) noexcept { std::free(header_of(object)); }

void __cxa_throw(void* object, std::type_info* type, Destroy destroy) {
  Header* const header = header_of(object);
  header->type = type;
  header->destroy = destroy;
  raise(header);
}

void* __cxa_get_exception_ptr(void* exception) noexcept { return header_of_unwind(exception)->adjusted; }

void* __cxa_begin_catch(void* exception) noexcept {
  Header* const header = header_of_unwind(exception);
  header->handlers = (header->handlers < 0 ? -header->handlers : header->handlers) + 1;
  --uncaught;
  if (header != caught) {
    header->next = caught;
    caught = header;
  }
  return header->adjusted;
}

void __cxa_end_catch() {
  Header* const header = caught;
  if (!header) return;
  if (header->handlers < 0) {  // thrown again, and still in flight: the next handler ends it
    if (++header->handlers == 0) caught = header->next;
    return;
  }
  if (--header->handlers > 0) return;
  caught = header->next;
  release(header);
}

void __cxa_rethrow() {
  if (!caught) std::terminate();
  caught->handlers = -caught->handlers;
  raise(caught);
}

std::type_info* __cxa_current_exception_type() { return caught ? const_cast<std::type_info*>(caught->type) : nullptr; }

void* __cxa_current_primary_exception() noexcept {
  if (!caught) return nullptr;
  Header* const first = caught->first ? caught->first : caught;
  ++first->references;
  return first->object;
}

void __cxa_increment_exception_refcount(void* object) noexcept {
  if (object) ++header_of(object)->references;
}

void __cxa_decrement_exception_refcount(void* object) noexcept {
  if (object) release(header_of(object));
}

void __cxa_rethrow_primary_exception(void* object) {
  if (!object) return;
  Header* const header = new_header(0);
  header->first = header_of(object);
  ++header->first->references;
  header->type = header->first->type;
  header->object = object;
  raise(header);
}

bool __cxa_uncaught_exception() noexcept { return uncaught > 0; }
unsigned __cxa_uncaught_exceptions() noexcept { return uncaught; }

}  // extern "C"
