#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <sstream>
#include <vector>

#include "targets.hpp"

namespace multipath_localization::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int kMutationsPerFile = 300;

/// Files are written by the thousand, and waited for until they are on the disk: in memory they are so at
/// once.
const bool kInMemory = fs::exists("/dev/shm") && setenv("TMPDIR", "/dev/shm", 1) == 0;

std::string content_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The cases of a target by the name of their file, in its order.
std::map<std::string, std::string> corpus_of(const std::string& target) {
  std::map<std::string, std::string> corpus;
  for (const auto& entry : fs::directory_iterator(fs::path(CORPUS_DIR) / target)) {
    corpus[entry.path().filename().string()] = content_of(entry.path());
  }
  return corpus;
}

/// Spoils bytes as libFuzzer does, without its eyes.
class Mutator {
 public:
  std::string mutated(std::string bytes) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(bytes);
    return bytes;
  }

 private:
  void change(std::string& bytes) {
    const std::size_t place = below(bytes.size() + 1);
    switch (below(5)) {
      case 0: bytes.resize(place); break;
      case 1: bytes.insert(place, bytes.substr(below(bytes.size() + 1), below(40))); break;
      case 2: bytes.erase(place, below(20)); break;
      case 3: bytes.insert(place, kNasty[below(std::size(kNasty))]); break;
      default:
        if (place < bytes.size()) bytes[place] = static_cast<char>(below(256));
    }
  }

  std::size_t below(std::size_t bound) { return random_() % bound; }

  static constexpr const char* kNasty[] = {"nan", "inf",      "-",  "1e308", "-1e308", "9999999999",
                                           "0",   "&a ",      "*a", "[",     "{",      "\n",
                                           ",",   "\xff\xff", ": ", "1e-320"};
  std::mt19937 random_{1};
};

class Corpus : public testing::TestWithParam<std::string> {
 protected:
  void run(const std::string& bytes, const std::string& what) const {
    try {
      targets().at(GetParam())(bytes);
    } catch (const std::exception& error) {
      ADD_FAILURE() << what << ": " << error.what() << "\n" << testing::PrintToString(bytes);
    }
  }
};

TEST_P(Corpus, IsReadOrRefusedAsDocumented) {
  const auto corpus = corpus_of(GetParam());
  EXPECT_GE(corpus.size(), 3U) << (kInMemory ? "" : "from the disk");
  for (const auto& [name, bytes] : corpus) run(bytes, name);
}

TEST_P(Corpus, IsSoWhenItIsSpoilt) {
  Mutator mutator;
  for (const auto& [name, bytes] : corpus_of(GetParam())) {
    for (int i = 0; i < kMutationsPerFile && !HasFailure(); ++i) run(mutator.mutated(bytes), name);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, target] : targets()) all.push_back(name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(names()),
                         [](const auto& target) { return target.param; });

TEST(Corpora, AreOfTargetsAlone) {
  for (const auto& entry : fs::directory_iterator(CORPUS_DIR)) {
    EXPECT_EQ(targets().count(entry.path().filename().string()), 1U) << entry.path();
  }
}

}  // namespace
}  // namespace multipath_localization::fuzz
