#pragma once

/// @file
/// What a library that the thread sanitizer does not see into does between threads, said to it by us. Nothing in
/// other builds.

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define UNBRUISED_THREAD_SANITIZER
#endif
#endif

#ifdef UNBRUISED_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(void* object);  // NOLINT: the sanitizer's names
void __tsan_release(void* object);  // NOLINT
}
#endif

namespace unbruised::studies {

/// What this thread did so far happened before what another does after `take_over` of the same object.
inline void hand_over([[maybe_unused]] void* object) {
#ifdef UNBRUISED_THREAD_SANITIZER
  __tsan_release(object);
#endif
}

/// Comes after every `hand_over` of the object before it.
inline void take_over([[maybe_unused]] void* object) {
#ifdef UNBRUISED_THREAD_SANITIZER
  __tsan_acquire(object);
#endif
}

}  // namespace unbruised::studies
