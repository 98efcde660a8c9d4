// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text/step_lines.h"

#include <chrono>
#include <cstdio>

namespace swept::step {
namespace {

using Eigen::Vector3d;

std::string ref(Id id) {
  std::string text = std::to_string(id);
  text.insert(text.begin(), '#');
  return text;
}

// Returns the code point of UTF-8 at `at` and advances `at`. A byte counts as a code point by
// itself if it cannot begin one, or if the text ends before the bytes that should follow it. The
// values of these bytes are not checked.
char32_t codePoint(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  if (at + static_cast<std::size_t>(more) >= text.size()) return byte(at++);
  char32_t value = more == 0 ? first : first & (0x3FU >> more);
  for (int k = 1; k <= more; ++k) value = (value << 6U) | (byte(at + k) & 0x3FU);
  at += more + 1;
  return value;
}

// Returns the present time in UTC as STEP files state it, such as 2026-01-31T23:59:59.
std::string timeStamp() {
  namespace chrono = std::chrono;
  const auto now = chrono::floor<chrono::seconds>(chrono::system_clock::now());
  const auto midnight = chrono::floor<chrono::days>(now);
  const chrono::year_month_day day{midnight};
  const chrono::hh_mm_ss time{now - midnight};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d", int{day.year()},
                unsigned{day.month()}, unsigned{day.day()}, static_cast<int>(time.hours().count()),
                static_cast<int>(time.minutes().count()), static_cast<int>(time.seconds().count()));
  return text.data();
}

}  // namespace

void FileSections::header(const std::string& fileName) {
  lines_.raw("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((");
  lines_.raw(stepString("Envelope of a moving body: " + options_.productName));
  lines_.raw("),'2;1');\nFILE_NAME(").raw(stepString(fileName)).raw(",'").raw(timeStamp());
  lines_.raw("',(").raw(stepString(options_.author)).raw("),(");
  lines_.raw(stepString(options_.organization));
  lines_.raw("),'Swept Volume','Swept Volume for FreeCAD','');\nFILE_SCHEMA(('");
  lines_.raw(is242() ? "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }"
                     : "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 }");
  lines_.raw("'));\nENDSEC;\nDATA;\n");
}

Id FileSections::point(const Vector3d& p) {
  const Id id = lines_.begin("CARTESIAN_POINT");
  lines_.raw("'',").triple(p, true).end();
  return id;
}
Id FileSections::direction(const Vector3d& d) {
  const Id id = lines_.begin("DIRECTION");
  lines_.raw("'',").triple(d, false).end();
  return id;
}
Id FileSections::placement(const Vector3d& origin, const Vector3d& axis, const Vector3d& x) {
  const Id at = point(origin), up = direction(axis), across = direction(x);
  const Id id = lines_.begin("AXIS2_PLACEMENT_3D");
  lines_.raw("'',").id(at).raw(",").id(up).raw(",").id(across).end();
  return id;
}

Id FileSections::plain(const char* keyword, Words arguments) {
  const Id id = lines_.begin(keyword);
  for (const std::string& word : arguments) lines_.raw(word);
  lines_.end();
  return id;
}
// An entity of several types has no keyword before its parentheses. The keywords of all its types
// are inside the parentheses, so plain() gets an empty keyword here.
Id FileSections::context(double exact) {
  const Id mm = plain("", {"LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)"});
  const Id radian = plain("", {"NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.)"});
  const Id steradian = plain("", {"NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()"});
  const Id accuracy = lines_.begin("UNCERTAINTY_MEASURE_WITH_UNIT");
  lines_.raw("LENGTH_MEASURE(").ratio(exact).raw("),").id(mm);
  lines_.raw(",'distance_accuracy_value','confusion accuracy'").end();
  return plain("", {"GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((",
                    ref(accuracy), ")) GLOBAL_UNIT_ASSIGNED_CONTEXT((", ref(mm), ",", ref(radian),
                    ",", ref(steradian), ")) REPRESENTATION_CONTEXT('Context #1',",
                    "'3D Context with UNIT and UNCERTAINTY')"});
}

void FileSections::product(const char* representation, const std::vector<Id>& items,
                           const std::vector<Id>& coloured, Id contextId) {
  const std::string name = stepString(options_.productName);
  const Id shape = lines_.begin(representation);
  lines_.raw(name).raw(",").ids(items).raw(",").id(contextId).end();
  const Id application =
      plain("APPLICATION_CONTEXT", {is242() ? "'managed model based 3d engineering'"
                                            : "'core data for automotive mechanical design "
                                              "processes'"});
  plain("APPLICATION_PROTOCOL_DEFINITION",
        {"'international standard',",
         is242() ? "'ap242_managed_model_based_3d_engineering',2014," : "'automotive_design',2000,",
         ref(application)});
  const Id productContext = plain("PRODUCT_CONTEXT", {"'',", ref(application), ",'mechanical'"});
  const Id thing = plain("PRODUCT", {name, ",", name, ",'',(", ref(productContext), ")"});
  plain("PRODUCT_RELATED_PRODUCT_CATEGORY", {"'part',$,(", ref(thing), ")"});
  const Id formation = plain("PRODUCT_DEFINITION_FORMATION", {"'','',", ref(thing)});
  const Id design =
      plain("PRODUCT_DEFINITION_CONTEXT", {"'part definition',", ref(application), ",'design'"});
  const Id definition =
      plain("PRODUCT_DEFINITION", {"'design','',", ref(formation), ",", ref(design)});
  const Id definitionShape = plain("PRODUCT_DEFINITION_SHAPE", {"'','',", ref(definition)});
  plain("SHAPE_DEFINITION_REPRESENTATION", {ref(definitionShape), ",", ref(shape)});
  colour(coloured, contextId);
}

void FileSections::colour(const std::vector<Id>& items, Id contextId) {
  const Id paint = lines_.begin("COLOUR_RGB");
  lines_.raw("''");
  for (const double part : options_.colour) lines_.raw(",").ratio(part);
  lines_.end();
  const Id fillColour = plain("FILL_AREA_STYLE_COLOUR", {"'',", ref(paint)});
  const Id fill = plain("FILL_AREA_STYLE", {"'',(", ref(fillColour), ")"});
  const Id area = plain("SURFACE_STYLE_FILL_AREA", {ref(fill)});
  const Id side = plain("SURFACE_SIDE_STYLE", {"'',(", ref(area), ")"});
  const Id usage = plain("SURFACE_STYLE_USAGE", {".BOTH.,", ref(side)});
  const Id style = plain("PRESENTATION_STYLE_ASSIGNMENT", {"(", ref(usage), ")"});
  std::vector<Id> styled;
  for (const Id solid : items) {
    styled.push_back(plain("STYLED_ITEM", {"'color',(", ref(style), "),", ref(solid)}));
  }
  lines_.begin("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION");
  lines_.raw("'',").ids(styled).raw(",").id(contextId).end();
}

void FileSections::end() { lines_.raw("ENDSEC;\nEND-ISO-10303-21;\n").flush(); }

std::string stepString(const std::string& utf8) {
  std::string result = "'";
  for (std::size_t at = 0; at < utf8.size();) {
    const char32_t c = codePoint(utf8, at);
    if (c == '\'' || c == '\\') {
      result.append(2, static_cast<char>(c));
    } else if (c >= 0x20 && c < 0x7F) {
      result += static_cast<char>(c);
    } else {
      std::array<char, 24> code{};
      std::snprintf(code.data(), code.size(), c > 0xFFFF ? "\\X4\\%08X\\X0\\" : "\\X2\\%04X\\X0\\",
                    static_cast<unsigned>(c));
      result += code.data();
    }
  }
  return result + "'";
}

}  // namespace swept::step
