#include "handles.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace lapfx::c {

namespace {

constexpr std::array kinds = {"none",        "lapfx_context", "lapfx_organ", "lapfx_preset",
                              "lapfx_scene", "lapfx_effects", "lapfx_frame"};

/// A handle is, from its lowest bit: 1, which no address of an object has; the kind; the slot; a number that is never
/// given again.
constexpr unsigned kind_bits = 3, slot_bits = 14;
constexpr std::size_t most_objects = std::size_t{1} << slot_bits;
static_assert(sizeof(void*) == 8 && kinds.size() <= std::size_t{1} << kind_bits);

std::uintptr_t number_of(const void* handle) {
    return reinterpret_cast<std::uintptr_t>(handle);
}
std::size_t kind_of(std::uintptr_t number) {
    return number >> 1 & ((1U << kind_bits) - 1);
}

struct Slot {
    std::atomic<std::uintptr_t> number{0};  ///< a handle with this number leads here; 0: none does
    std::atomic<unsigned> holders{0};
    std::atomic<Object*> object{nullptr};
};
// Never destroyed, as objects that are still alive when the program ends: their OpenGL may be gone then.
std::array<Slot, most_objects> slots;

Slot& slot_of(std::uintptr_t number) {
    return slots[number >> (1 + kind_bits) & (most_objects - 1)];
}

/// Slots that no handle leads to.
struct FreeSlots {
    std::mutex mutex;
    std::size_t used_so_far = 0;
    std::vector<std::size_t> given_back;
    std::uintptr_t serial = 0;

    /// A new handle; its slot is not filled yet.
    std::uintptr_t take(Kind kind) {
        const std::lock_guard lock(mutex);
        given_back.reserve(most_objects);  // giving back never fails then
        if (given_back.empty() && used_so_far == most_objects)
            throw Misuse(std::to_string(most_objects) + " objects are alive already: destroy those that are not used");
        std::size_t index = used_so_far;
        if (given_back.empty()) {
            ++used_so_far;
        } else {
            index = given_back.back();
            given_back.pop_back();
        }
        const std::uintptr_t place = index << (1 + kind_bits) | static_cast<std::uintptr_t>(kind) << 1 | 1;
        return ++serial << (1 + kind_bits + slot_bits) | place;
    }
    void give_back(const Slot& slot) {
        const std::lock_guard lock(mutex);
        given_back.push_back(static_cast<std::size_t>(&slot - slots.data()));
    }
};
FreeSlots& free_slots() {
    static FreeSlots& kept = *new FreeSlots;  // as the slots
    return kept;
}

[[noreturn]] void refuse(const void* handle, Kind kind, const char* argument) {
    const std::string name = argument, wanted = kinds[static_cast<std::size_t>(kind)];
    if (handle == nullptr) throw Misuse(name + " is NULL; expected a " + wanted);
    const std::uintptr_t number = number_of(handle);
    if (slot_of(number).number == number && kind_of(number) != static_cast<std::size_t>(kind))
        throw Misuse(name + " is a " + kinds[kind_of(number)] + "; expected a " + wanted);
    throw Misuse(name + " is no " + wanted + " that lives: it was destroyed, or lapfx never made it");
}

}  // namespace

void* add(Kind kind, std::unique_ptr<Object> object) {
    const std::uintptr_t number = free_slots().take(kind);
    Slot& slot = slot_of(number);
    slot.object = object.release();
    slot.number = number;
    return reinterpret_cast<void*>(number);
}

Object* hold(const void* handle, Kind kind, const char* argument) {
    const std::uintptr_t number = number_of(handle);
    Slot& slot = slot_of(number);
    ++slot.holders;  // before looking: from here on take_out() waits
    if (number != 0 && slot.number == number && kind_of(number) == static_cast<std::size_t>(kind)) return slot.object;
    --slot.holders;
    refuse(handle, kind, argument);
}

void release(const void* handle) noexcept {
    --slot_of(number_of(handle)).holders;
}

std::unique_ptr<Object> take_out(const void* handle, Kind kind, const char* argument) {
    std::uintptr_t number = number_of(handle);
    Slot& slot = slot_of(number);
    if (number == 0 || kind_of(number) != static_cast<std::size_t>(kind) ||
        !slot.number.compare_exchange_strong(number, 0))
        refuse(handle, kind, argument);
    while (slot.holders != 0) std::this_thread::yield();
    std::unique_ptr<Object> object(slot.object.exchange(nullptr));
    free_slots().give_back(slot);
    return object;
}

}  // namespace lapfx::c
