// Is this compiled for the thread sanitizer? It has an operator new of its own: no test can count allocations under it.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define SUNDER_UNDER_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SUNDER_UNDER_THREAD_SANITIZER 1
#endif
#endif
#ifndef SUNDER_UNDER_THREAD_SANITIZER
#define SUNDER_UNDER_THREAD_SANITIZER 0
#endif
