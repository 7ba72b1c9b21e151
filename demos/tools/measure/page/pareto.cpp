#include "measure/page/pareto.h"

#include <algorithm>

namespace demos::measure {

std::vector<bool> paretoFront(const std::vector<Point>& points) {
    std::vector<bool> front;
    for (const Point& point : points) {
        front.push_back(std::none_of(points.begin(), points.end(), [&](const Point& other) {
            return other.cost <= point.cost && other.error <= point.error &&
                   (other.cost < point.cost || other.error < point.error);
        }));
    }
    return front;
}

} // namespace demos::measure
