#include "guidance/xml_file.hpp"

namespace multipath_localization {

void read_xml(const std::string& file, tinyxml2::XMLDocument& document) {
  document.LoadFile(file.c_str());
  if (document.Error()) {
    const int line = document.ErrorLineNum();
    throw FilePlace{file, line > 0 ? std::to_string(line) : ""}.error(document.ErrorName());
  }
  if (document.RootElement() == nullptr) throw FilePlace{file}.error("no XML element");
}

std::string local_name(const tinyxml2::XMLElement& element) {
  const std::string name = element.Name();
  return name.substr(name.find(':') + 1);
}

// tinyxml2 reads no file that is nested so deep that this would run out of stack.
void visit(const tinyxml2::XMLElement& element,
           const std::function<bool(const tinyxml2::XMLElement&)>& take) {
  if (take(element)) return;
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    visit(*child, take);
  }
}

FilePlace place_of(const std::string& file, const tinyxml2::XMLElement& element) {
  return {file, std::to_string(element.GetLineNum())};
}

}  // namespace multipath_localization
