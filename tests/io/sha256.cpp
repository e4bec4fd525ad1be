#include "lodlab/io/sha256.hpp"

#include "tests/catch.hpp"

TEST_CASE("the hash of texts is the one of the standard") {
    // FIPS 180-4, examples of NIST.
    CHECK(io::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(io::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(io::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(io::sha256(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a hash tells apart where one text ends and the next begins") {
    const auto of = [](const std::string& a, const std::string& b) {
        io::Sha256 hash;
        hash.add(std::string_view(a));
        hash.add(std::string_view(b));
        return hash.hexadecimal();
    };
    CHECK(of("ab", "c") != of("a", "bc"));
    CHECK(of("ab", "c") == of("ab", "c"));
}
