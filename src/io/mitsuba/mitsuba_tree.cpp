#include "mitsuba_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <system_error>
#include <utility>

#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

/// The tags of the elements of a scene.
constexpr std::array<std::string_view, 35> mitsuba_tags{
    "scene",   "shape",  "bsdf",    "emitter", "sensor",    "film",   "sampler", "rfilter",   "integrator",
    "texture", "medium", "phase",   "volume",  "spectrum",  "rgb",    "srgb",    "blackbody", "float",
    "integer", "string", "boolean", "point",   "vector",    "matrix", "rotate",  "scale",     "translate",
    "lookat",  "lookAt", "ref",     "default", "transform", "alias",  "include", "path"};

constexpr int deepest_node_of_xml = 100, deepest_include = 15;  // the second as Mitsuba has it
constexpr std::size_t most_nodes = 1'000'000, most_includes = 1000, longest_value = 1'000'000;

constexpr bool is_xml_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The place at which the attribute of a number begins, in an element of well-formed XML.
std::size_t attribute_place(std::string_view text, std::size_t element, std::size_t number) {
  std::size_t at = element;
  const auto skip = [&](auto&& is_passed) {
    while (at < text.size() && is_passed(text[at])) ++at;
  };
  skip([](char c) { return !is_xml_blank(c); });
  for (;; --number) {
    skip(is_xml_blank);
    if (number == 0) return std::min(at, text.size());
    skip([](char c) { return c != '"' && c != '\''; });
    const char quote = at < text.size() ? text[at] : '"';
    ++at;
    skip([&](char c) { return c != quote; });
    ++at;
  }
}

/// toWorld as to_world, intIOR as int_ior: Mitsuba 0.6 wrote names so.
std::string underscored(std::string_view name) {
  std::string made;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool is_great = 'A' <= name[i] && name[i] <= 'Z';
    if (is_great && i > 0 && 'a' <= name[i - 1] && name[i - 1] <= 'z') made += '_';
    made += is_great ? static_cast<char>(name[i] | 0x20) : name[i];
  }
  return made;
}

class MitsubaFiles {
 public:
  explicit MitsubaFiles(const Source& source)
      : tree_{{std::make_shared<const Source>(source), 0, "scene"}, SceneFolder(source)} {}

  MitsubaTree read() {
    const std::shared_ptr<const Source> file = tree_.scene.file;
    std::vector<MitsubaNode> top;
    read_file(file, top, 0);
    if (top.size() != 1 || top.front().tag != "scene")
      file->fail(0, "no scene", "expected an element scene that holds all others");
    tree_.scene = std::move(top.front());
    return std::move(tree_);
  }

 private:
  /// Adds the outermost element of a file, or what is in it where it is included.
  void read_file(const std::shared_ptr<const Source>& file, std::vector<MitsubaNode>& into, int depth) {
    if (const std::size_t zero = file->text().find('\0'); zero != std::string_view::npos)
      file->fail(zero, "a byte 0", "expected a text in XML");
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(file->text().data(), file->text().size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result)
      file->fail(std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), file->text().size()),
                 fmt::format("no XML: {}", text::escaped(result.description())), "expected elements and attributes");
    std::vector<MitsubaNode> outermost;
    for (const pugi::xml_node node : document.children()) read_node(file, node, outermost, depth, 1);
    if (outermost.size() != 1) file->fail(0, fmt::format("{} outermost elements", outermost.size()), "expected one");
    const bool is_inner = depth > 0 && outermost.front().tag == "scene";
    for (MitsubaNode& node : is_inner ? outermost.front().children : outermost) into.push_back(std::move(node));
  }

  void read_node(const std::shared_ptr<const Source>& file, const pugi::xml_node& from, std::vector<MitsubaNode>& into,
                 int depth, int level) {
    const std::size_t name_at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(from.offset_debug(), 1));
    MitsubaNode node{file, name_at - 1, from.name()};
    if (level > deepest_node_of_xml)
      node.fail(fmt::format("elements within each other, deeper than {}", deepest_node_of_xml),
                fmt::format("expected {} at most", deepest_node_of_xml));
    if (++elements_ > most_nodes)
      node.fail(fmt::format("more than {} elements", most_nodes), "expected fewer, with what is included");
    if (std::ranges::find(mitsuba_tags, node.tag) == mitsuba_tags.end())
      node.fail(fmt::format("element {} is not read", text::shown(node.tag)),
                "expected " + text::expected_of(node.tag, {mitsuba_tags.begin(), mitsuba_tags.end()}));
    read_attributes(from, name_at, node);
    if (is_carried_out(node, into, depth)) return;
    for (const pugi::xml_node child : from.children()) read_node(file, child, node.children, depth, level + 1);
    into.push_back(std::move(node));
  }

  void read_attributes(const pugi::xml_node& from, std::size_t name_at, MitsubaNode& node) {
    std::size_t number = 0;
    for (const pugi::xml_attribute attribute : from.attributes()) {
      const std::size_t at = attribute_place(node.file->text(), name_at, number++);
      const auto [place, is_new] = node.attributes.try_emplace(attribute.name(), MitsubaAttribute{"", at});
      if (!is_new) node.file->fail(at, fmt::format("a second {}", text::shown(attribute.name())), "expected one");
      place->second.value = with_defaults(*node.file, at, attribute.value());
    }
    node.property = underscored(node.value_of("name"));
  }

  /// The value in which the names of `default` behind a $ are replaced: the longest of those that fit.
  std::string with_defaults(const Source& file, std::size_t at, std::string_view value) const {
    std::string made;
    for (std::size_t dollar; (dollar = value.find('$')) != std::string_view::npos;) {
      made += value.substr(0, dollar);
      value.remove_prefix(dollar + 1);
      const std::pair<const std::string, std::string>* longest = nullptr;
      for (const auto& known : defaults_)
        if (value.starts_with(known.first) && (longest == nullptr || known.first.size() > longest->first.size()))
          longest = &known;
      if (longest == nullptr)
        file.fail(at, fmt::format("{} has no value", text::shown("$" + std::string(value))),
                  "expected the name of a default above");
      made += longest->second;
      value.remove_prefix(longest->first.size());
      if (made.size() > longest_value)
        file.fail(at, fmt::format("a value of more than {} characters", longest_value), "expected a shorter one");
    }
    return made += value;
  }

  /// Carries a node out that stands for no thing. False of any other.
  bool is_carried_out(const MitsubaNode& node, std::vector<MitsubaNode>& into, int depth) {
    if (node.tag == "default") {
      const std::string_view name = node.required("name");
      if (name.empty()) node.fail("a default without a name", "expected one", "name");
      defaults_.try_emplace(std::string(name), node.required("value"));
    } else if (node.tag == "path") {
      tree_.outer_paths += !tree_.folder.add(*node.file, node.required("value"));
    } else if (node.tag == "alias") {
      tree_.aliases.insert_or_assign(std::string(node.required("as")), node.required("id"));
    } else if (node.tag == "include") {
      include(node, into, depth);
    } else {
      return false;
    }
    return true;
  }

  void include(const MitsubaNode& node, std::vector<MitsubaNode>& into, int depth) {
    const std::string_view name = node.required("filename");
    if (depth == deepest_include || ++files_ > most_includes)
      node.fail("too many files that include files",
                fmt::format("expected {} within each other and {} in all, at most", deepest_include, most_includes));
    const auto path = tree_.folder.find(*node.file, name);
    if (!path) node.fail(fmt::format("no file {}", text::shown(name)), tree_.folder.expected(), "filename");
    read_file(std::make_shared<const Source>(read_source(*path)), into, depth + 1);
  }

  MitsubaTree tree_;
  std::map<std::string, std::string, std::less<>> defaults_;
  std::size_t elements_ = 0, files_ = 0;
};

}  // namespace

std::string_view MitsubaNode::value_of(std::string_view attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? std::string_view() : std::string_view(found->second.value);
}

std::string_view MitsubaNode::required(std::string_view attribute) const {
  if (!attributes.contains(attribute))
    fail(fmt::format("{} without {}", tag, attribute), fmt::format("expected an attribute {}", attribute));
  return value_of(attribute);
}

void MitsubaNode::fail(const std::string& wrong, const std::string& expected, std::string_view attribute) const {
  const auto found = attributes.find(attribute);
  file->fail(found == attributes.end() ? at : found->second.at, wrong, expected);
}

MitsubaTree read_mitsuba_tree(const Source& source) { return MitsubaFiles(source).read(); }

}  // namespace durero::io
