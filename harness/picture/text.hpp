#pragma once

#include "picture/picture.hpp"

#include <memory>
#include <string>

namespace reliefbench {

/// The labels' font, DejaVu Sans, which is built in. Sizes are in pixels from the top of the tallest letter to the
/// bottom of the deepest; text is UTF-8.
class Font {
public:
    Font();
    ~Font();

    int line_height(int size) const;
    int width(const std::string& text, int size) const;
    /// `left`, `top`: of the line; clipped by the picture's border.
    void draw(Picture& picture, int left, int top, const std::string& text, int size, const Rgb8& colour) const;
    /// Without its end, for which an ellipsis stands, where it is wider than `most`.
    std::string shortened(const std::string& text, int size, int most) const;

private:
    struct Face;
    std::unique_ptr<Face> face_;
};

}  // namespace reliefbench
