// A picture as the eye has it, row by row: its colours as sharp as they are resolved, and what stands out.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "metrics/flip/weigh.h"
#include "metrics/image.h"

namespace demos {

/// Makes linear light, 0..1, of a row of a picture's values, in place.
using ToLight = std::function<void(std::vector<float>&)>;

/// Of the eye at a distance.
struct EyeFilters {
    explicit EyeFilters(float pixelsPerDegree);

    Kernel achromatic, redGreen, blueYellowWide, blueYellowNarrow;
    Kernel smooth, slope, bend; ///< edges and points: the first and second derivative of a Gaussian
    float wideShare = 0;        ///< of blue and yellow; the rest is narrow
    size_t radius = 0;          ///< of the widest
};

/// Some columns of a picture.
struct Strip {
    PixelView picture;
    size_t left = 0, width = 0;
};

class Seen {
  public:
    Seen(const Strip& strip, const EyeFilters& eye, const ToLight& toLight);

    /// Rows are asked for from the top; each may be left out.
    void goTo(size_t y);
    /// Of the row: L*a*b* with the Hunt effect, and the strengths of edges and points.
    const std::array<std::vector<float>, 3>& lab() const { return lab_; }
    const std::vector<float>& edges() const { return edges_; }
    const std::vector<float>& points() const { return points_; }

  private:
    /// A row after the filters' first axis.
    enum Plane { achromatic, redGreen, wide, narrow, smooth, slope, bend, planes };
    struct Filtered {
        size_t y = SIZE_MAX;
        std::array<std::vector<float>, planes> rows;
    };

    void readRow(size_t y);
    void filterAlongX(size_t y, Filtered& to);
    void filterAlongY(size_t y, Plane plane, const Kernel& kernel, std::vector<float>& to);
    void toLab();

    const Strip strip_;
    const EyeFilters& eye_;
    const ToLight& toLight_;
    std::array<std::vector<float>, 3> light_, opponent_; // with the filters' radius at both sides
    std::vector<Filtered> ring_;
    std::vector<const float*> at_;
    std::array<std::vector<float>, 3> lab_;
    std::vector<float> narrow_, edges_, points_, other_;
};

} // namespace demos
