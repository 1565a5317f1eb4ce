// Whether a test runs under AddressSanitizer, where memory is reserved otherwise and exact numbers are slow.
#pragma once

namespace toolcomp::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TOOLCOMP_UNDER_ADDRESS_SANITIZER
#endif
#endif

#ifdef TOOLCOMP_UNDER_ADDRESS_SANITIZER
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace toolcomp::test
