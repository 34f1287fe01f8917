#include "guidance/xml_file.hpp"

namespace multipath_localization {

namespace {

using tinyxml2::XMLElement;

/// What follows an element and all within it, inside of `whole`; none at its end.
const XMLElement* next_after(const XMLElement& element, const XMLElement& whole) {
  const XMLElement* at = &element;
  while (at != &whole) {
    if (const XMLElement* next = at->NextSiblingElement()) return next;
    at = at->Parent()->ToElement();
  }
  return nullptr;
}

}  // namespace

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

void visit(const XMLElement& element, const std::function<bool(const XMLElement&)>& take) {
  for (const XMLElement* at = &element; at != nullptr;) {
    const XMLElement* within = take(*at) ? nullptr : at->FirstChildElement();
    at = within != nullptr ? within : next_after(*at, element);
  }
}

FilePlace place_of(const std::string& file, const tinyxml2::XMLElement& element) {
  return {file, std::to_string(element.GetLineNum())};
}

}  // namespace multipath_localization
