#include "measure/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "measure/html.h"
#include "measure/pareto.h"

namespace demos::measure {

namespace {

constexpr double width = 480, height = 300, left = 60, right = 90, top = 20, bottom = 50;
constexpr const char* style = R"(<style>
.plot { fill: #dcdfe2; font: 11px system-ui, sans-serif; }
.back { fill: #1b1d1f; }
.grid { stroke: #33373b; }
.front { fill: none; stroke: #6cb2ff; stroke-width: 1.5; stroke-dasharray: 4 3; }
.spread { stroke: #dcdfe2; }
.best { fill: #6cb2ff; }
.beaten { fill: #1b1d1f; stroke: #a4abb2; stroke-width: 1.5; }
</style>
<rect class="back" width="100%" height="100%"/>
)";
constexpr int gaps = 4; ///< between ticks

template<class... Numbers>
std::string print(const char* format, Numbers... numbers) {
    char text[512];
    std::snprintf(text, sizeof(text), format, numbers...);
    return text;
}

/// Linear from 0 to somewhat above the greatest.
class Axis {
  public:
    Axis(double greatest, double from, double to) : from_(from), to_(to) {
        const double step = (greatest > 0 ? greatest * 1.05 : 1) / gaps;
        const double power = std::pow(10, std::floor(std::log10(step)));
        for (const double multiple : {1.0, 2.0, 2.5, 5.0, 10.0})
            if (most_ == 0 && multiple * power >= step) most_ = multiple * power * gaps;
        if (most_ == 0) most_ = 10 * power * gaps;
    }
    double at(double value) const { return from_ + (to_ - from_) * value / most_; }
    double tick(int i) const { return most_ * i / gaps; }

  private:
    double from_, to_, most_ = 0;
};

struct Mark {
    std::string name;
    Point point;
    double spread = 0; ///< of the cost
};

std::vector<Mark> marksOf(const Tradeoff& tradeoff, const Sheet& sheet) {
    std::vector<Mark> marks;
    for (const Entry& entry : tradeoff.of(sheet)) {
        if (!entry.cost.xFloor || !entry.error.flip) continue;
        marks.push_back({entry.name(),
                         {*entry.cost.xFloor, *entry.error.flip},
                         entry.cost.reflection.spreadMs / entry.cost.floor.ms});
    }
    return marks;
}

std::string frameOf(const Axis& x, const Axis& y) {
    std::string svg;
    for (int i = 0; i <= gaps; ++i) {
        svg += print("<line class=\"grid\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n",
                     x.at(x.tick(i)), top, x.at(x.tick(i)), height - bottom);
        svg += print("<line class=\"grid\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", left,
                     y.at(y.tick(i)), width - right, y.at(y.tick(i)));
        svg += print("<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%.3g</text>\n", x.at(x.tick(i)),
                     height - bottom + 16, x.tick(i));
        svg += print("<text text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">%.3g</text>\n", left - 6,
                     y.at(y.tick(i)) + 4, y.tick(i));
    }
    svg += print("<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">cost, multiples of the floor</text>\n",
                 (left + width - right) / 2, height - 12);
    svg += print("<text text-anchor=\"middle\" transform=\"translate(14 %.1f) rotate(-90)\">FLIP over the "
                 "water</text>\n",
                 (top + height - bottom) / 2);
    return svg;
}

} // namespace

std::string plotSvg(const Tradeoff& tradeoff, const Sheet& sheet) {
    const std::vector<Mark> marks = marksOf(tradeoff, sheet);
    Point most;
    std::vector<Point> points;
    for (const Mark& mark : marks) {
        points.push_back(mark.point);
        most = {std::max(most.cost, mark.point.cost + mark.spread / 2),
                std::max(most.error, mark.point.error)};
    }
    const Axis x(most.cost, left, width - right), y(most.error, height - bottom, top);
    std::string svg =
        print("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 %.0f %.0f\" "
              "role=\"img\" aria-label=\"Error against cost\">\n",
              width, height) +
        style + frameOf(x, y);

    const std::vector<bool> front = paretoFront(points);
    std::vector<Point> joined;
    for (size_t i = 0; i < points.size(); ++i)
        if (front[i]) joined.push_back(points[i]);
    std::sort(joined.begin(), joined.end(), [](const Point& a, const Point& b) { return a.cost < b.cost; });
    std::string line;
    for (const Point& point : joined) line += print("%.1f,%.1f ", x.at(point.cost), y.at(point.error));
    svg += "<polyline class=\"front\" points=\"" + line + "\"/>\n";

    for (size_t i = 0; i < marks.size(); ++i) {
        const Point& point = points[i];
        svg += print("<line class=\"spread\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n",
                     x.at(std::max(point.cost - marks[i].spread / 2, 0.0)), y.at(point.error),
                     x.at(point.cost + marks[i].spread / 2), y.at(point.error));
        svg += print("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>\n", front[i] ? "best" : "beaten",
                     x.at(point.cost), y.at(point.error));
        // Names of marks that fall together go below each other.
        const auto above = std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                                         [&](const Point& other) {
                                             return std::abs(x.at(other.cost) - x.at(point.cost)) < 40 &&
                                                    std::abs(y.at(other.error) - y.at(point.error)) < 12;
                                         });
        svg += print("<text x=\"%.1f\" y=\"%.1f\">", x.at(point.cost) + 9,
                     y.at(point.error) - 5 + 13 * static_cast<double>(above)) +
               escaped(marks[i].name) + "</text>\n";
    }
    return svg + "</svg>\n";
}

} // namespace demos::measure
