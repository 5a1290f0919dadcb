// An array of numbers that are 0 until they are written: what nobody writes to costs neither time nor memory, so that
// a place can be looked up among millions without a frame that prepares them all.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace lapfx::organ {

template <class Number>
class Zeroed {
    static_assert(std::is_arithmetic_v<Number>);

  public:
    Zeroed() = default;
    /// Throws std::bad_alloc.
    explicit Zeroed(std::size_t size)
        // calloc() asks the system for pages, which are 0 and are made when they are first written.
        : numbers_(static_cast<Number*>(std::calloc(size > 0 ? size : 1, sizeof(Number)))) {
        if (!numbers_) throw std::bad_alloc();
    }

    Number& operator[](std::size_t i) { return numbers_.get()[i]; }
    const Number& operator[](std::size_t i) const { return numbers_.get()[i]; }

  private:
    struct Free {
        void operator()(Number* numbers) const { std::free(numbers); }
    };
    std::unique_ptr<Number, Free> numbers_;
};

}  // namespace lapfx::organ
