#include "measure/page/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "measure/page/pareto.h"

namespace demos::measure {

namespace {

/// Colours are those of the page.
constexpr const char* style = R"(set encoding utf8
set border 3 lc rgb "#a4abb2"
set grid lc rgb "#33373b" lt 1
set tics nomirror scale 0.5 textcolor rgb "#dcdfe2"
set xlabel "cost, multiples of the floor" textcolor rgb "#dcdfe2"
set ylabel "FLIP over what mirrors" textcolor rgb "#dcdfe2"
set key off
set rmargin 22
)";

constexpr double freeBelowLeast = 4; ///< how many times less than the least cost the place of none is

struct Mark {
    std::string label;
    Point point;
    double spread = 0; ///< of the cost
};

template<class... Numbers>
std::string print(const char* format, Numbers... numbers) {
    char text[256];
    std::snprintf(text, sizeof(text), format, numbers...);
    return text;
}

/// Without what would end a text of gnuplot's.
std::string quoted(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '"' || c == '\\' || c == '\n'; }, ' ');
    return '"' + text + '"';
}

std::vector<Mark> marksOf(const Tradeoff& tradeoff, const Sheet& sheet) {
    std::vector<Mark> marks;
    for (const Entry& entry : tradeoff.of(sheet)) {
        if (!entry.cost.xFloor || !entry.error.flip) continue;
        marks.push_back({entry.quality == "default" ? entry.technique : entry.name(),
                         {*entry.cost.xFloor, *entry.error.flip},
                         entry.cost.xFloorSpread.value_or(0)});
    }
    return marks;
}

/// Costs on a logarithmic axis that has a place for nothing as well.
class CostAxis {
  public:
    explicit CostAxis(const std::vector<Mark>& marks) {
        for (const Mark& mark : marks) {
            const double cost = mark.point.cost;
            if (cost > 0) least_ = least_ > 0 ? std::min(least_, cost) : cost;
            most_ = std::max(most_, cost + mark.spread);
        }
        if (least_ == 0) least_ = most_ = 1;
    }
    double at(double cost) const { return std::max(cost, none()); }
    double none() const { return least_ / freeBelowLeast; }

    std::string script() const {
        std::string text =
            print("set logscale x\nset xrange [%.6g:%.6g]\nset xtics (\"0\" %.6g", lower(), upper(), none());
        const double first = std::pow(10, std::floor(std::log10(least_)));
        for (double decade = first; decade < upper(); decade *= 10)
            for (const double multiple : {1.0, 2.0, 5.0})
                if (multiple * decade > 1.5 * none() && multiple * decade < upper())
                    text += print(", \"%.6g\" %.6g", multiple * decade, multiple * decade);
        return text + ")\n";
    }

  private:
    double lower() const { return none() / 1.5; }
    double upper() const { return most_ * 2; }

    double least_ = 0, most_ = 0;
};

std::string frontData(const std::vector<Mark>& marks, const std::vector<bool>& front, const CostAxis& costs) {
    std::vector<Point> joined;
    for (size_t i = 0; i < marks.size(); ++i)
        if (front[i]) joined.push_back(marks[i].point);
    std::sort(joined.begin(), joined.end(), [](const Point& a, const Point& b) { return a.cost < b.cost; });
    std::string data = "# the Pareto front: cost, error\n$front << EOD\n";
    for (const Point& point : joined) data += print("%.6g %.6g\n", costs.at(point.cost), point.error);
    return data + "EOD\n";
}

std::string markData(const char* name, const std::vector<Mark>& marks, const std::vector<bool>& chosen,
                     bool which, const CostAxis& costs) {
    std::string data = print("# cost, its quartiles, error\n$%s << EOD\n", name);
    for (size_t i = 0; i < marks.size(); ++i) {
        if (chosen[i] != which) continue;
        const Point& point = marks[i].point;
        data +=
            print("%.6g %.6g %.6g %.6g\n", costs.at(point.cost), costs.at(point.cost - marks[i].spread / 2),
                  costs.at(point.cost + marks[i].spread / 2), point.error);
    }
    return data + "EOD\n";
}

/// Marks lie too close for names: numbers beside them, and names beside the plot.
std::string labels(const std::vector<Mark>& marks, const CostAxis& costs) {
    std::string text;
    for (size_t i = 0; i < marks.size(); ++i) {
        const auto number = static_cast<int>(i) + 1;
        text += print("set label \"%d\" at %.6g,%.6g left offset 0.5,0.5 textcolor rgb \"#dcdfe2\"\n", number,
                      costs.at(marks[i].point.cost), marks[i].point.error);
        text += "set label " + quoted(std::to_string(number) + "  " + marks[i].label) +
                print(" at graph 1.03, graph %.4f left noenhanced textcolor rgb \"#dcdfe2\"\n",
                      1 - 0.06 * static_cast<double>(i));
    }
    return text;
}

} // namespace

std::string plotScript(const Tradeoff& tradeoff, const Sheet& sheet, const std::string& svg) {
    const std::vector<Mark> marks = marksOf(tradeoff, sheet);
    std::vector<Point> points;
    double mostError = 0;
    for (const Mark& mark : marks) {
        points.push_back(mark.point);
        mostError = std::max(mostError, mark.point.error);
    }
    if (mostError == 0) mostError = 1;
    const std::vector<bool> front = paretoFront(points);
    const CostAxis costs(marks);
    std::string script =
        "set terminal svg size 720,420 dynamic background \"#1b1d1f\" font \"sans-serif,12\"\n";
    script += "set output " + quoted(svg) + "\n" + style + costs.script();
    script += print("set yrange [0:%.6g]\n", 1.15 * mostError);
    script += frontData(marks, front, costs) + markData("best", marks, front, true, costs) +
              markData("beaten", marks, front, false, costs) + labels(marks, costs);
    script += "plot $front using 1:2 with lines lc rgb \"#6cb2ff\" dt 2";
    for (const auto& [name, look] :
         {std::pair{"best", "lc rgb \"#6cb2ff\" pt 7"}, std::pair{"beaten", "lc rgb \"#a4abb2\" pt 6"}}) {
        const bool which = name == std::string("best");
        if (std::find(front.begin(), front.end(), which) == front.end()) continue;
        script += print(", \\\n  $%s using 1:4:2:3 with xerrorbars ps 1 %s", name, look);
    }
    return script + "\n";
}

} // namespace demos::measure
