#include "durero/io/mesh/mesh_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/sarif.hpp"
#include "durero/text/shown.hpp"
#include "point_text.hpp"

namespace durero::io {
namespace {

constexpr std::array<SarifRule, 8> rules{{{"abiertas", "An edge has two faces."},
                                          {"multiples", "An edge has no more than two faces."},
                                          {"discordes", "Two faces walk their common edge in opposite ways."},
                                          {"repetidas", "No two faces have the same vertices."},
                                          {"degeneradas", "The corners of a face do not lie on one line."},
                                          {"uniones_en_t", "No vertex lies within an edge."},
                                          {"cruzadas", "Faces meet in the corners and edges that they share alone."},
                                          {"singulares", "The faces of a vertex are one fan."}}};

template <class Values, class Text>
std::string listed(const Values& values, const char* between, const Text& text) {
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : between) + text(value);
  return all;
}

const std::string& itself(const std::string& text) { return text; }

/// The defect in words, and the operations that mend it.
std::string said_of(const MeshDefect& defect) {
  std::string text = fmt::format("{}: {}", listed(defect.places, " ", point_text), defect.message);
  if (!defect.mended.empty()) text += "; mended by " + listed(defect.mended, ", then ", itself);
  return text;
}

std::string line_of(const MeshDefect& defect) {
  return fmt::format("{}: {}: {}\n", defect.kind, listed(defect.faces, ", ", itself), said_of(defect));
}

void write_texts(json::Writer& out, std::string_view name, const std::vector<std::string>& texts) {
  out.key(name).begin_array();
  for (const std::string& text : texts) out.value(text);
  out.end_array();
}

void write_defect(json::Writer& out, const MeshDefect& defect) {
  out.new_line().begin_object().member("kind", defect.kind);
  write_texts(out, "faces", defect.faces);
  out.key("places").begin_array();
  for (const glm::dvec3& place : defect.places) out.value(place);
  out.end_array().member("message", defect.message);
  write_texts(out, "mended", defect.mended);
  out.end_object();
}

std::string point_line(const MeshPoint& point) {
  const std::string side = point.side == "none"      ? "on no side, as the triangles bound nothing"
                           : point.side == "surface" ? "on the surface"
                                                     : point.side;
  return fmt::format("{}: {}\n", point_text(point.place), side);
}

/// The volume of triangles in words.
std::string volume_text(const std::optional<std::string>& volume) {
  return volume.value_or("none, as they bound none");
}

/// A line for each piece, where there are several.
std::string piece_lines(const MeshCheck& check) {
  std::string text;
  if (check.pieces < 2) return text;
  for (const AuditedPiece& piece : check.listed_pieces)
    text += fmt::format("piece of {}: {} triangle{}, volume {}\n", piece.first, piece.faces,
                        piece.faces == 1 ? "" : "s", volume_text(piece.volume));
  if (check.pieces > check.listed_pieces.size())
    text += fmt::format("pieces: {} more\n", check.pieces - check.listed_pieces.size());
  return text;
}

void write_pieces(json::Writer& out, const MeshCheck& check) {
  out.key("each_piece").begin_array();
  for (const AuditedPiece& piece : check.listed_pieces) {
    out.begin_object().member("first", piece.first).member("triangles", std::uint64_t{piece.faces});
    if (piece.volume) out.member("volume", *piece.volume);
    out.end_object();
  }
  out.end_array();
}

void write_unlisted(json::Writer& out, const MeshCheck& check) {
  out.key("unlisted").begin_object();
  for (const UnlistedFindings& rest : check.unlisted) out.member(rest.kind, std::uint64_t{rest.count});
  out.end_object();
}

/// The findings of a kind that are not listed, in words.
std::string said_of(const UnlistedFindings& rest) { return fmt::format("{} more", rest.count); }

/// A result without a region: a format may have no lines. The triangles are its logical locations.
void write_result(json::Writer& out, std::string_view uri, const MeshDefect& defect) {
  out.new_line().begin_object().member("ruleId", defect.kind).member("level", "error");
  write_sarif_message(out, "message", said_of(defect));
  out.key("locations").begin_array().begin_object().key("physicalLocation").begin_object();
  out.key("artifactLocation").begin_object().member("uri", uri).end_object().end_object();
  out.key("logicalLocations").begin_array();
  for (const std::string& face : defect.faces) out.begin_object().member("fullyQualifiedName", face).end_object();
  out.end_array().end_object().end_array().end_object();
}

}  // namespace

std::string mesh_check_text(const MeshCheck& check) {
  std::string text = fmt::format(
      "{}: {} triangles, {} vertices, {}, volume {}\n", text::escaped(check.file), check.faces, check.vertices,
      check.pieces == 1 ? "1 piece" : fmt::format("{} pieces", check.pieces), volume_text(check.volume));
  text += piece_lines(check);
  if (check.point) text += point_line(*check.point);
  for (const MeshDefect& defect : check.findings) text += line_of(defect);
  for (const UnlistedFindings& rest : check.unlisted) text += fmt::format("{}: {}\n", rest.kind, said_of(rest));
  return text;
}

std::string mesh_check_json(const MeshCheck& check) {
  std::string text;
  json::Writer out(text);
  write_version(out.begin_object(), mesh_check_format);
  out.member("file", text::escaped(check.file)).member("ok", check.findings.empty());
  out.member("triangles", std::uint64_t{check.faces}).member("vertices", std::uint64_t{check.vertices});
  out.member("pieces", std::uint64_t{check.pieces});
  if (check.volume) out.member("volume", *check.volume);
  write_pieces(out, check);
  if (check.point)
    out.key("point").begin_object().member("place", check.point->place).member("side", check.point->side).end_object();
  out.key("findings").begin_array();
  for (const MeshDefect& defect : check.findings) write_defect(out, defect);
  out.end_array();
  if (!check.unlisted.empty()) write_unlisted(out, check);
  out.end_object();
  return text + '\n';
}

std::string mesh_check_sarif(const MeshCheck& check) {
  std::string text;
  json::Writer out(text);
  begin_sarif(out, "durero check", rules);
  out.key("results").begin_array();
  const std::string uri = sarif_uri(check.file);
  for (const MeshDefect& defect : check.findings) write_result(out, uri, defect);
  for (const UnlistedFindings& rest : check.unlisted) {
    write_sarif_message(out.new_line().begin_object().member("ruleId", rest.kind).member("level", "error"), "message",
                        said_of(rest));
    out.end_object();
  }
  end_sarif(out);
  return text + '\n';
}

}  // namespace durero::io
