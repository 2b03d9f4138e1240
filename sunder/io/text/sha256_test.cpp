#include <sunder/io/text/sha256.h>
#include <sunder/io/text/sha256_internal.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

// The examples of NIST for FIPS 180-4, one block, two, and many.
TEST(Sha256, Examples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Around the ends of blocks, where the padding takes one block more.
TEST(Sha256, EveryLength) {
  std::string digests;
  for (int n = 0; n < 200; ++n) {
    std::string bytes;
    for (int k = 0; k < n; ++k) bytes += static_cast<char>((7 * k + n) % 256);
    digests += sha256(bytes);
    ASSERT_EQ(sha256_plainly(bytes), sha256(bytes)) << n;  // processors have instructions for it, or not
  }
  EXPECT_EQ(sha256_plainly(digests), sha256(digests));
  // By another implementation: Python's hashlib.
  EXPECT_EQ(sha256(digests), "b8f5d54cfd1cbbcae2003d1365d9fab7e5bc61813fa3486ee6a6a6bf38db4745");
}

}  // namespace
}  // namespace sunder::io
