// How many members an aggregate has, for tests of tables that have a row for each.
#pragma once

#include <cstddef>

namespace lapfx::test {

/// Stands for a value of any type.
struct Anything {
    template <class T>
    operator T() const;
};

template <class T, class... Members>
constexpr std::size_t count_members() {
    if constexpr (requires { T{Members{}..., Anything{}}; })
        return count_members<T, Members..., Anything>();
    else
        return sizeof...(Members);
}

}  // namespace lapfx::test
