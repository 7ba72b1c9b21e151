#include "measure/page/html.h"

namespace demos {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '@': // which would be taken for a name to fill in
            result += "&#64;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

} // namespace demos
