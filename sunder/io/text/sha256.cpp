#include <sunder/io/text/bytes.h>
#include <sunder/io/text/sha256.h>
#include <sunder/io/text/sha256_internal.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace sunder::io {

namespace {

using Words = std::array<std::uint32_t, 8>;

constexpr std::size_t block = 64;  // bytes

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes (FIPS 180-4, section 4.2.2).
constexpr std::array<std::uint32_t, 64> constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

// Section 6.2.2.
void take_block(const char* bytes, Words& hash) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t t = 0; t < 16; ++t) w[t] = load<std::uint32_t>(bytes + 4 * t, ByteOrder::big_endian);
  for (std::size_t t = 16; t < 64; ++t) {
    const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = hash;
  for (std::size_t t = 0; t < 64; ++t) {
    const std::uint32_t sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const std::uint32_t sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const std::uint32_t t1 = h + sum1 + ((e & f) ^ (~e & g)) + constants[t] + w[t];
    const std::uint32_t t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + t2;
  }
  const Words step{a, b, c, d, e, f, g, h};
  for (std::size_t k = 0; k < hash.size(); ++k) hash[k] += step[k];
}

void take_blocks(const char* bytes, std::size_t count, Words& hash) {
  for (std::size_t k = 0; k < count; ++k) take_block(bytes + k * block, hash);
}

#if defined(__x86_64__)

bool has_instructions() {
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
  if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) == 0 || (ecx & bit_SSE4_1) == 0 || (ecx & bit_SSSE3) == 0) return false;
  return __get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0 && (ebx & bit_SHA) != 0;
}

// The same by the processor's instructions, which take two rounds each, on the words a, b, e, f and c, d, g, h.
// Requires has_instructions().
__attribute__((target("sha,sse4.1"))) void take_blocks_by_instructions(const char* bytes, std::size_t count,
                                                                       Words& hash) {
  const auto lanes = [](std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w) {
    const std::array words{w, z, y, x};
    __m128i four;
    std::memcpy(&four, words.data(), sizeof four);
    return four;
  };
  const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
  __m128i abef = lanes(hash[0], hash[1], hash[4], hash[5]), cdgh = lanes(hash[2], hash[3], hash[6], hash[7]);
  for (; count > 0; --count, bytes += block) {
    const __m128i abef_before = abef, cdgh_before = cdgh;
    __m128i w[4];  // the last sixteen words of the schedule, in turn
    for (unsigned g = 0; g < 16; ++g) {
      __m128i &now = w[g % 4], &last = w[(g + 3) % 4];
      if (g < 4) {
        __m128i given;
        std::memcpy(&given, bytes + 16 * g, 16);
        now = _mm_shuffle_epi8(given, big_endian);
      } else {
        const __m128i seven_before = _mm_alignr_epi8(last, w[(g + 2) % 4], 4);
        now = _mm_sha256msg2_epu32(_mm_add_epi32(_mm_sha256msg1_epu32(now, w[(g + 1) % 4]), seven_before), last);
      }
      __m128i k;
      std::memcpy(&k, constants.data() + std::size_t{4} * g, 16);
      k = _mm_add_epi32(now, k);
      cdgh = _mm_sha256rnds2_epu32(cdgh, abef, k);
      abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(k, 0x0e));
    }
    abef = _mm_add_epi32(abef, abef_before);
    cdgh = _mm_add_epi32(cdgh, cdgh_before);
  }
  std::array<std::uint32_t, 4> first{}, second{};
  std::memcpy(first.data(), &abef, sizeof abef);
  std::memcpy(second.data(), &cdgh, sizeof cdgh);
  hash = {first[3], first[2], second[3], second[2], first[1], first[0], second[1], second[0]};
}

#endif

// What does not fill a block; a one; zeros; and the number of bits (section 5.1.1).
std::string padded(std::string_view rest, std::uint64_t bytes) {
  std::string last(rest);
  last += '\x80';
  last.resize((last.size() + 8 + block - 1) / block * block - 8, '\0');
  for (int shift = 56; shift >= 0; shift -= 8) last += static_cast<char>(bytes * 8 >> shift & 0xff);
  return last;
}

std::string sha256_by(void (*take)(const char*, std::size_t, Words&), std::string_view bytes) {
  Words hash{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  const std::size_t whole = bytes.size() / block;
  take(bytes.data(), whole, hash);
  const std::string last = padded(bytes.substr(whole * block), bytes.size());
  take(last.data(), last.size() / block, hash);
  std::string digits;
  for (const std::uint32_t word : hash) {
    for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
  }
  return digits;
}

}  // namespace

std::string sha256_plainly(std::string_view bytes) { return sha256_by(take_blocks, bytes); }

std::string sha256(std::string_view bytes) {
#if defined(__x86_64__)
  static const bool by_instructions = has_instructions();
  if (by_instructions) return sha256_by(take_blocks_by_instructions, bytes);
#endif
  return sha256_plainly(bytes);
}

}  // namespace sunder::io
