// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/parse/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry::ply {
namespace {

constexpr std::size_t most_elements = 64;
constexpr std::size_t most_properties = 256;

[[noreturn]] void fail(const Input& input, const std::string& problem) {
  throw Error(input.name() + ": PLY header: " + problem);
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t end = 0;
  while (words.size() < 8) {
    const std::size_t begin = line.find_first_not_of(" \t", end);
    if (begin == std::string_view::npos) break;
    end = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
  return words;
}

Type type_of(const Input& input, std::string_view name) {
  struct Name {
    std::string_view name;
    Type type;
  };
  constexpr std::array names{
      Name{"char", Type::int8},      Name{"int8", Type::int8},       Name{"uchar", Type::uint8},
      Name{"uint8", Type::uint8},    Name{"short", Type::int16},     Name{"int16", Type::int16},
      Name{"ushort", Type::uint16},  Name{"uint16", Type::uint16},   Name{"int", Type::int32},
      Name{"int32", Type::int32},    Name{"uint", Type::uint32},     Name{"uint32", Type::uint32},
      Name{"float", Type::float32},  Name{"float32", Type::float32}, Name{"double", Type::float64},
      Name{"float64", Type::float64}};
  const auto* found = std::find_if(names.begin(), names.end(), [&](const Name& known) { return known.name == name; });
  if (found == names.end())
    fail(input, "\"" + std::string(name.substr(0, 40)) + "\" is not a type; use float, double, uchar, int ...");
  return found->type;
}

Encoding encoding_of(const Input& input, const std::vector<std::string_view>& words) {
  if (words.size() < 2) fail(input, "the format line names no format");
  if (words[1] == "ascii") return Encoding::text;
  if (words[1] == "binary_little_endian") return Encoding::little_endian;
  if (words[1] == "binary_big_endian") return Encoding::big_endian;
  fail(input, "format \"" + std::string(words[1].substr(0, 40)) +
                  "\" is unknown; use ascii, binary_little_endian or binary_big_endian");
}

Element element_of(const Input& input, const std::vector<std::string_view>& words) {
  if (words.size() != 3) fail(input, "an element line is not \"element NAME COUNT\"");
  Element element{std::string(words[1].substr(0, 64)), 0, {}};
  const std::string_view count = words[2];
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc() || end != count.data() + count.size())
    fail(input, "element " + element.name + " has the count \"" + std::string(count.substr(0, 40)) +
                    "\", which is not a number");
  return element;
}

Property property_of(const Input& input, const std::vector<std::string_view>& words) {
  if (words.size() == 5 && words[1] == "list") {
    const Type count = type_of(input, words[2]);
    if (count == Type::float32 || count == Type::float64) fail(input, "a list is counted by a float; use uchar or int");
    return {std::string(words[4].substr(0, 64)), type_of(input, words[3]), count};
  }
  if (words.size() != 3)
    fail(input, "a property line is neither \"property TYPE NAME\" nor \"property list TYPE TYPE NAME\"");
  return {std::string(words[2].substr(0, 64)), type_of(input, words[1]), std::nullopt};
}

void check_sizes(const Input& input, const Header& header) {
  const std::optional<std::uint64_t> left = input.remaining();
  if (!left) return;
  long double needed = 0;
  for (const Element& element : header.elements) {
    needed += static_cast<long double>(element.count) * static_cast<long double>(element.least_size(header.encoding));
    // The last number of a text file needs no white space after it.
    if (needed > static_cast<long double>(*left) + (header.encoding == Encoding::text ? 1 : 0))
      fail(input, fmt::format("it announces {} of element {}, for which the file is too short ({} bytes follow the "
                              "header); the file is cut off or its header wrong, get it again",
                              element.count, element.name, *left));
  }
}

}  // namespace

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool Element::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const Property& property) { return property.count_type.has_value(); });
}

std::uint64_t Element::least_size(Encoding encoding) const {
  if (encoding == Encoding::text) return 2 * properties.size();
  std::uint64_t size = 0;
  for (const Property& property : properties) size += size_of(property.count_type.value_or(property.type));
  return size;
}

Header read_header(Input& input) {
  Header header;
  bool has_format = false;
  std::string_view line;
  if (!input.line(line) || words_of(line) != std::vector<std::string_view>{"ply"})
    throw Error(input.name() +
                ": is not a PLY file: it does not begin with \"ply\"; check the format, or give the file the ending it "
                "should have");
  for (;;) {
    if (!input.line(line)) fail(input, "the file ends before \"end_header\"; it is cut off, get it again");
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format") {
      header.encoding = encoding_of(input, words);
      has_format = true;
    } else if (words[0] == "element") {
      if (header.elements.size() == most_elements)
        fail(input, fmt::format("more than {} elements; remove some", most_elements));
      header.elements.push_back(element_of(input, words));
    } else if (words[0] == "property") {
      if (header.elements.empty()) fail(input, "a property stands before any element");
      std::vector<Property>& properties = header.elements.back().properties;
      if (properties.size() == most_properties)
        fail(input, fmt::format("more than {} properties; remove some", most_properties));
      properties.push_back(property_of(input, words));
    } else {
      fail(input, "the line begins with \"" + std::string(words[0].substr(0, 40)) +
                      "\"; format, element, property, comment or end_header is due");
    }
  }
  if (!has_format) fail(input, "the format line is missing; add \"format ascii 1.0\" or what the file has");
  check_sizes(input, header);
  return header;
}

}  // namespace glark::geometry::ply
