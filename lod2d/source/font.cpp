#include "lodlab/lod2d/source/font.hpp"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cstdio>
#include <memory>
#include <type_traits>

#include "lodlab/core/base/error.hpp"

namespace lod2d {
namespace {

template <typename T, auto release>
struct Release {
    void operator()(T* p) const { release(p); }
};
using Config = std::unique_ptr<FcConfig, Release<FcConfig, FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Release<FcPattern, FcPatternDestroy>>;
using Library = std::unique_ptr<std::remove_pointer_t<FT_Library>,
                                Release<std::remove_pointer_t<FT_Library>, FT_Done_FreeType>>;
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>,
                             Release<std::remove_pointer_t<FT_Face>, FT_Done_Face>>;

[[noreturn]] void refuse(lod::ErrorKind kind, std::string_view text, const std::string& why) {
    std::string shown(text);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';  // an error is one line
    throw lod::Error(kind, "cannot use 'text:" + shown + "': " + why);
}

/// The characters of a UTF-8 text.
std::vector<char32_t> decode(std::string_view text) {
    const auto fail = [&]() -> char32_t {
        throw lod::Error(lod::ErrorKind::input_refused,
                         "cannot use the text: it is no UTF-8; save or type it as UTF-8");
    };
    std::vector<char32_t> characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        const int more = lead < 0x80    ? 0
                         : lead >= 0xf0 ? 3
                         : lead >= 0xe0 ? 2
                         : lead >= 0xc2 ? 1
                                        : -1;
        if (more < 0 || lead > 0xf4) fail();
        char32_t code = more == 0 ? lead : lead & (0x3fu >> more);
        for (int k = 0; k < more; ++k) {
            const auto next = i < text.size() ? static_cast<unsigned char>(text[i++]) : 0u;
            if ((next & 0xc0u) != 0x80u) fail();
            code = code << 6 | (next & 0x3fu);
        }
        characters.push_back(code);
    }
    return characters;
}

struct FontFile {
    std::string path;
    int index = 0;
    std::string name;
};

FontFile find_font(std::string_view text, const std::string& wanted) {
    const auto none = [&]() {
        refuse(lod::ErrorKind::not_installed, text,
               "no font is installed; type: sudo apt-get install fonts-inter");
    };
    const Config config(FcInitLoadConfigAndFonts());
    if (!config) none();
    const Pattern pattern(FcNameParse(reinterpret_cast<const FcChar8*>(wanted.c_str())));
    if (!pattern)
        refuse(lod::ErrorKind::usage, text,
               "'" + wanted + "' is no font name; write a name such as Inter or Inter:bold");
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultMatch;
    const Pattern found(FcFontMatch(config.get(), pattern.get(), &result));
    FcChar8* path = nullptr;
    FcChar8* family = nullptr;
    FontFile font;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &path) != FcResultMatch) none();
    if (FcPatternGetString(found.get(), FC_FAMILY, 0, &family) == FcResultMatch)
        font.name = reinterpret_cast<const char*>(family);
    FcPatternGetInteger(found.get(), FC_INDEX, 0, &font.index);
    font.path = reinterpret_cast<const char*>(path);
    return font;
}

/// Where FreeType's pen draws: font units, y up.
struct Pen {
    CurvePath path;
    Point origin = Point::Zero();
    [[nodiscard]] Point at(const FT_Vector* p) const {
        return origin + Point(static_cast<double>(p->x), static_cast<double>(p->y));
    }
};

Pen& pen_of(void* user) {
    return *static_cast<Pen*>(user);
}

const FT_Outline_Funcs pen_moves = {
    [](const FT_Vector* to, void* user) {
        pen_of(user).path.close();
        pen_of(user).path.move_to(pen_of(user).at(to));
        return 0;
    },
    [](const FT_Vector* to, void* user) {
        pen_of(user).path.line_to(pen_of(user).at(to));
        return 0;
    },
    [](const FT_Vector* control, const FT_Vector* to, void* user) {
        pen_of(user).path.quadratic_to(pen_of(user).at(control), pen_of(user).at(to));
        return 0;
    },
    [](const FT_Vector* control_1, const FT_Vector* control_2, const FT_Vector* to, void* user) {
        pen_of(user).path.cubic_to(pen_of(user).at(control_1), pen_of(user).at(control_2),
                                   pen_of(user).at(to));
        return 0;
    },
    0,
    0};

std::string named(char32_t character) {
    char code[16];
    std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(character));
    return code;
}

CurvePath draw_text(std::string_view text, const std::vector<char32_t>& characters,
                    const FontFile& font, FT_Face face) {
    Pen pen;
    FT_UInt previous = 0;
    for (char32_t character : characters) {
        const FT_UInt glyph = FT_Get_Char_Index(face, character);
        if (glyph == 0)
            refuse(lod::ErrorKind::input_refused, text,
                   "the font " + font.name + " has no glyph for " + named(character) +
                       "; choose another font or another text");
        const bool loaded = FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) == 0;
        if (!loaded || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
            refuse(lod::ErrorKind::input_refused, text,
                   "the font " + font.name + " has no outline for " + named(character) +
                       "; choose another font");
        FT_Vector kerning{0, 0};
        if (previous != 0) FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNSCALED, &kerning);
        pen.origin.x() += static_cast<double>(kerning.x);
        FT_Outline_Decompose(&face->glyph->outline, &pen_moves, &pen);
        pen.path.close();
        pen.origin.x() += static_cast<double>(face->glyph->advance.x);
        previous = glyph;
    }
    return std::move(pen.path);
}

}  // namespace

Shape text_shape(std::string_view text, const FontSettings& settings) {
    const std::vector<char32_t> characters = decode(text);
    if (characters.size() > settings.most_characters)
        refuse(lod::ErrorKind::limit_exceeded, text.substr(0, 20),
               "it has " + std::to_string(characters.size()) + " characters, the limit is " +
                   std::to_string(settings.most_characters) + "; shorten it or raise the limit");
    const FontFile font = find_font(text, settings.font);

    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened) != 0)
        refuse(lod::ErrorKind::not_installed, text,
               "FreeType does not start; install libfreetype6");
    const Library library(opened);
    FT_Face face = nullptr;
    if (FT_New_Face(library.get(), font.path.c_str(), font.index, &face) != 0)
        refuse(lod::ErrorKind::input_refused, text,
               "the font file " + font.path + " cannot be read; choose another font");
    const Face owned(face);

    CurvePath path = draw_text(text, characters, font, face);
    if (path.empty())
        refuse(lod::ErrorKind::input_refused, text, "it draws nothing; give at least one letter");
    return shape_of("text:" + std::string(text), {{std::move(path), FillRule::nonzero}},
                    settings.outline);
}

}  // namespace lod2d
