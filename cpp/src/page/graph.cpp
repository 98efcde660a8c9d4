// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/number_text.h"
#include "page/html.h"

namespace swept::page {
namespace {

constexpr double kWidth = 880, kHeight = 340, kLeft = 56, kRight = 14, kTop = 14, kBottom = 40;
// The first six colours are from Okabe and Ito, 2008.
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                              "#56b4e9", "#e69f00", "#7a4fbf", "#8c564b"};
constexpr std::size_t kRowLength = 4;  // names per row of the legend
constexpr std::size_t kLetters = 26;   // largest number of letters of a name
constexpr double kTickGap = 16, kLegendRow = 19;
constexpr const char* kOther = "#999999";

std::string at(double value) { return fixedText(value, 1); }

// Cuts a long name after kLetters letters, never inside a UTF-8 character.
std::string shortened(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t end = 0; end < text.size(); ++end) {
    const bool first = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (first && ++count > kLetters) return text.substr(0, end) + "...";
  }
  return text;
}

std::string stroke(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return "<line x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" + at(y2) +
         "\" " + attributes + "/>\n";
}

std::string label(double x, double y, const char* anchor, const std::string& text,
                  const std::string& attributes = "fill=\"#333333\"") {
  return "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor + "\" " +
         attributes + ">" + escaped(text) + "</text>\n";
}

class Graph {
 public:
  Graph(const CheckReport& check, const Words& words) : words_(words) {
    for (const std::size_t index : check.order)
      if (!check.rows[index].curve.empty()) curves_.push_back(&check.rows[index]);
    if (!curves_.empty()) measure();
  }

  bool isEmpty() const { return curves_.empty(); }

  /// Returns the svg element. With `follows`, it includes the line that marks the moment shown in
  /// the 3D view.
  std::string text(bool follows) const {
    const std::size_t named = std::min(curves_.size(), kColours.size());
    const std::size_t names = named + (curves_.size() > named ? 1 : 0);
    const double height = kHeight + kLegendRow * double((names + kRowLength - 1) / kRowLength);
    std::string svg =
        "<svg class=\"graph\" xmlns=\"http://www.w3.org/2000/svg\" width=\"" + at(kWidth) +
        "\" height=\"" + at(height) + "\" viewBox=\"0 0 " + at(kWidth) + " " + at(height) +
        "\" font-family=\"sans-serif\" font-size=\"12\" data-from=\"" + numberText(from_, 17) +
        "\" data-to=\"" + numberText(to_, 17) + "\" data-left=\"" + at(kLeft) + "\" data-right=\"" +
        at(kWidth - kRight) + "\">\n" + distanceTicks() + timeTicks() + demands();
    for (std::size_t i = curves_.size(); i-- > 0;) svg += curve(i);
    if (follows)
      svg += stroke(kLeft, kTop, kLeft, kHeight - kBottom,
                    "id=\"graph-now\" stroke=\"#333333\" visibility=\"hidden\"");
    return svg + legend(named, names) + "</svg>\n";
  }

 private:
  void measure() {
    from_ = to_ = curves_[0]->curve[0].first;
    double largestRequired = 0;
    for (const Row* row : curves_) {
      largestRequired = std::max(largestRequired, row->required.value_or(0));
      for (const auto& [time, distance] : row->curve) {
        from_ = std::min(from_, time);
        to_ = std::max(to_, time);
        most_ = std::max(most_, distance);
      }
      if (row->required.value_or(0) > 0) required_.push_back(*row->required);
    }
    std::sort(required_.begin(), required_.end());
    required_.erase(std::unique(required_.begin(), required_.end()), required_.end());
    constexpr double kAbove = 1.2, kBend = 1.5, kBendDivisor = 20, kLeast = 1e-3;
    most_ = std::max({most_, kAbove * largestRequired, kLeast});
    linearRange_ = required_.empty() ? most_ / kBendDivisor : required_[0] / kBend;
    if (!(to_ > from_)) to_ = from_ + 1;
  }

  double x(double time) const {
    return kLeft + (time - from_) / (to_ - from_) * (kWidth - kLeft - kRight);
  }
  double y(double distance) const {
    const double fraction = std::asinh(distance / linearRange_) / std::asinh(most_ / linearRange_);
    return kHeight - kBottom - fraction * (kHeight - kTop - kBottom);
  }

  std::string distanceTicks() const {
    std::string svg;
    double last = kHeight + kTickGap;
    const auto tick = [&](double distance) {
      if (distance > most_ || last - y(distance) < kTickGap) return;
      last = y(distance);
      svg += stroke(kLeft, last, kWidth - kRight, last, "class=\"grid\" stroke=\"#dddddd\"");
      svg += label(kLeft - 6, last + 4, "end", words_.number(distance));
    };
    tick(0);
    for (int decade = -4; decade < 10; ++decade)
      for (const double step : {1.0, 2.0, 5.0}) tick(step * std::pow(10.0, decade));
    return svg + "<text transform=\"translate(13 " + at(0.5 * (kTop + kHeight - kBottom)) +
           ") rotate(-90)\" text-anchor=\"middle\" fill=\"#333333\">" +
           escaped(words_("axis_distance")) + "</text>\n";
  }

  std::string timeTicks() const {
    std::string svg;
    const double span = to_ - from_;
    const double unit = std::pow(10.0, std::floor(std::log10(span / 4)));
    const double step = unit * (span / unit > 20 ? 5 : span / unit > 8 ? 2 : 1);
    const double first = std::ceil(from_ / step - 1e-9);
    for (int k = 0; (first + k) * step <= to_ + 1e-9 * span; ++k) {
      const double time = (first + k) * step;
      svg += stroke(x(time), kTop, x(time), kHeight - kBottom, "class=\"grid\" stroke=\"#dddddd\"");
      svg += label(x(time), kHeight - kBottom + 16, "middle", words_.number(time));
    }
    return svg + label(0.5 * (kLeft + kWidth), kHeight - 6, "middle", words_("axis_time"));
  }

  // Draws one line for each different required distance.
  std::string demands() const {
    std::string svg;
    for (const double distance : required_) {
      svg += stroke(kLeft, y(distance), kWidth - kRight, y(distance),
                    "class=\"demand\" stroke=\"#c00000\" stroke-dasharray=\"6 4\"");
      svg += label(kWidth - kRight - 4, y(distance) - 4, "end",
                   words_("graph_required", words_.millimetres(distance)),
                   "class=\"demand\" fill=\"#c00000\"");
    }
    return svg;
  }

  static const char* colour(std::size_t i) { return i < kColours.size() ? kColours[i] : kOther; }

  // Draws a curve with a wide invisible line over it, which is easier to point at.
  std::string curve(std::size_t i) const {
    const Row& row = *curves_[i];
    const std::string title =
        "<title>" + escaped(row.name + ": " + words_.millimetres(row.distance)) + "</title>";
    const std::string begin = "<g class=\"curve\" data-row=\"" + escaped(row.name) + "\">" + title;
    if (row.curve.size() == 1)
      return begin + "<circle cx=\"" + at(x(row.curve[0].first)) + "\" cy=\"" +
             at(y(row.curve[0].second)) + "\" r=\"4\" fill=\"" + colour(i) + "\"/></g>\n";
    std::string points;
    for (const auto& [time, distance] : row.curve)
      points.append(points.empty() ? "" : " ").append(at(x(time)) + "," + at(y(distance)));
    const auto line = [&](const std::string& attributes) {
      return "<polyline fill=\"none\" " + attributes + " points=\"" + points + "\"/>";
    };
    return begin +
           line("class=\"line\" stroke=\"" + std::string(colour(i)) + "\" stroke-width=\"1.8\"") +
           line("stroke=\"#000000\" stroke-opacity=\"0\" stroke-width=\"11\"") + "</g>\n";
  }

  std::string legend(std::size_t named, std::size_t names) const {
    std::string svg;
    for (std::size_t i = 0; i < names; ++i) {
      const double left = kLeft + double(i % kRowLength) * (kWidth - kLeft) / kRowLength;
      const double line = kHeight + 12 + kLegendRow * double(i / kRowLength);
      svg += stroke(left, line - 4, left + 18, line - 4,
                    "stroke=\"" + std::string(colour(i)) + "\" stroke-width=\"2.5\"");
      svg += label(left + 24, line, "start",
                   i < named ? shortened(curves_[i]->name) : words_("others"));
    }
    return svg;
  }

  const Words& words_;
  std::vector<const Row*> curves_;  // rows that have a curve, the worst first
  std::vector<double> required_;    // the different required distances (mm), ascending
  double from_ = 0, to_ = 1, most_ = 0, linearRange_ = 1;
};

std::string figure(const CheckReport& check, const Words& words, bool follows) {
  const Graph graph(check, words);
  if (graph.isEmpty()) return {};
  std::string notes = escaped(words("graph_scale"));
  if (check.report.contains("range"))
    notes.append(" ").append(
        escaped(words("graph_range", words.millimetres(check.report["range"].get<double>()))));
  notes.append(" ").append(element("span", escaped(words("graph_names")), "screen"));
  return "<div class=\"wide\">" + graph.text(follows) + "</div>\n" + element("p", notes, "note");
}

}  // namespace

std::string graphOf(const CheckReport& check, const Words& words) {
  return section("graph", words("graph"), figure(check, words, true));
}

std::string graphFigure(const CheckReport& check, const Words& words) {
  return figure(check, words, false);
}

}  // namespace swept::page
