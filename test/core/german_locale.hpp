#pragma once

#include <stdlib.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

namespace multipath_localization {

/// While it lives numbers are written and read as Germans do, 1.234,5: by streams, and by printf and strtod,
/// as in a program whose GUI has set the user's locale.
class GermanLocale {
 public:
  GermanLocale() : streams_(std::locale::global(std::locale(std::locale::classic(), new Numbers))) {
    const std::string pattern = (std::filesystem::temp_directory_path() / "german_XXXXXX").string();
    std::string folder = pattern;
    folder_ = mkdtemp(folder.data());
    compile();
    setenv("LOCPATH", folder_.c_str(), 1);
    std::setlocale(LC_NUMERIC, "comma");
    unsetenv("LOCPATH");
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;
  ~GermanLocale() {
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(streams_);
    std::filesystem::remove_all(folder_);
  }

 private:
  class Numbers : public std::numpunct<char> {
    [[nodiscard]] char do_decimal_point() const override { return ','; }
    [[nodiscard]] char do_thousands_sep() const override { return '.'; }
    [[nodiscard]] std::string do_grouping() const override { return "\3"; }
  };

  /// A locale of our own: no machine needs to have a German one.
  void compile() const {
    std::ofstream(folder_ / "numbers") << "LC_NUMERIC\ndecimal_point \"<U002C>\"\nthousands_sep \"<U002E>\"\n"
                                          "grouping 3\nEND LC_NUMERIC\n";
    std::ofstream characters(folder_ / "characters");
    characters << "<code_set_name> ASCII\nCHARMAP\n" << std::hex << std::uppercase;
    for (int c = 0; c < 128; ++c) {
      const std::string zero = c < 16 ? "0" : "";
      characters << "<U00" << zero << c << "> \\x" << zero << c << " of ASCII\n";
    }
    characters << "END CHARMAP\n";
    characters.close();
    const std::string in = folder_.string();
    const std::string command =
        "cd " + in + " && localedef --no-archive -c -i ./numbers -f ./characters ./comma/";
    // Of the other categories, which are not used, it says that there are none.
    static_cast<void>(std::system((command + " >/dev/null 2>&1").c_str()));
  }

  std::locale streams_;
  std::filesystem::path folder_;
};

}  // namespace multipath_localization
