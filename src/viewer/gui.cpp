#include "viewer/gui.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <backends/imgui_impl_sdl.h>
#include <cfloat>
#include <cstddef>
#include <filesystem>

#include "scanshade/base/error.hpp"

namespace scanshade::viewer {
namespace {

constexpr float font_size = 15;

/// With Greek, superscripts and signs of mathematics; without it those are question marks.
constexpr const char* fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
};
constexpr ImWchar glyphs[] = {0x20,   0xff,    // Latin
                              0x2b0,  0x2ff,   // superscript letters
                              0x370,  0x3ff,   // Greek
                              0x1d2c, 0x1d6a,  // more letters above and below the line
                              0x2010, 0x2027,  // dashes
                              0x2070, 0x209f,  // superscripts and subscripts
                              0x2190, 0x21ff,  // arrows
                              0x2200, 0x22ff,  // mathematics
                              0x25a0, 0x25ff,  // shapes
                              0};

int index_of(Uint8 button) {
    switch (button) {
        case SDL_BUTTON_LEFT:
            return 0;
        case SDL_BUTTON_RIGHT:
            return 1;
        case SDL_BUTTON_MIDDLE:
            return 2;
        default:
            return -1;
    }
}

}  // namespace

Gui::Gui(SDL_Window* window, SDL_Renderer* renderer) : renderer_(renderer) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // leaves no file behind
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.FrameRounding = style.WindowRounding = 0;
    // Slopes are drawn pixel by pixel by a software renderer: no soft rims.
    style.AntiAliasedFill = style.AntiAliasedLines = false;
    style.Colors[ImGuiCol_WindowBg].w = 0.94f;
    ImGui_ImplSDL2_InitForSDLRenderer(window);
    load_font();
}

Gui::~Gui() {
    font_.reset();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

void Gui::load_font() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::error_code ignored;
    for (const char* font : fonts)
        if (atlas.Fonts.empty() && std::filesystem::is_regular_file(font, ignored))
            atlas.AddFontFromFileTTF(font, font_size, nullptr, glyphs);
    if (atlas.Fonts.empty()) atlas.AddFontDefault();
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    font_.reset(SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC,
                                  width, height));
    if (!font_ || SDL_UpdateTexture(font_.get(), nullptr, pixels, 4 * width) != 0)
        throw Error(Errc::file, fmt::format("cannot draw letters ({})", SDL_GetError()));
    SDL_SetTextureBlendMode(font_.get(), SDL_BLENDMODE_BLEND);
    atlas.SetTexID(font_.get());
}

void Gui::process(const SDL_Event& event) {
    ImGui_ImplSDL2_ProcessEvent(&event);
    const int button = event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP
                           ? index_of(event.button.button)
                           : -1;
    if (button >= 0) {
        mouse_x_ = float(event.button.x), mouse_y_ = float(event.button.y);
        held_[std::size_t(button)] = event.type == SDL_MOUSEBUTTONDOWN;
        pressed_[std::size_t(button)] |= event.type == SDL_MOUSEBUTTONDOWN;
    }
    if (event.type == SDL_MOUSEMOTION)
        mouse_x_ = float(event.motion.x), mouse_y_ = float(event.motion.y);
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE)
        mouse_x_ = mouse_y_ = -FLT_MAX;
}

void Gui::take_mouse() {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {mouse_x_, mouse_y_};
    for (std::size_t i = 0; i < held_.size(); ++i) io.MouseDown[i] = held_[i] || pressed_[i];
    pressed_ = {};
}

void Gui::begin() {
    ImGui_ImplSDL2_NewFrame();
    take_mouse();
    ImGui::NewFrame();
}

void Gui::end() { ImGui::Render(); }

bool Gui::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Gui::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }

void Gui::draw() {
    const ImDrawData* data = ImGui::GetDrawData();
    if (data == nullptr) return;
    SDL_RenderSetScale(renderer_, data->FramebufferScale.x, data->FramebufferScale.y);
    for (int n = 0; n < data->CmdListsCount; ++n) {
        const ImDrawList& list = *data->CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4& c = command.ClipRect;
            const SDL_Rect clip{int(c.x), int(c.y), int(c.z) - int(c.x), int(c.w) - int(c.y)};
            if (clip.w <= 0 || clip.h <= 0) continue;
            SDL_RenderSetClipRect(renderer_, &clip);
            const ImDrawVert* v = list.VtxBuffer.Data + command.VtxOffset;
            SDL_RenderGeometryRaw(
                renderer_, static_cast<SDL_Texture*>(command.GetTexID()), &v->pos.x,
                sizeof(ImDrawVert), reinterpret_cast<const SDL_Color*>(&v->col), sizeof(ImDrawVert),
                &v->uv.x, sizeof(ImDrawVert), list.VtxBuffer.Size - int(command.VtxOffset),
                list.IdxBuffer.Data + command.IdxOffset, int(command.ElemCount), sizeof(ImDrawIdx));
        }
    }
    SDL_RenderSetClipRect(renderer_, nullptr);
    SDL_RenderSetScale(renderer_, 1, 1);
}

}  // namespace scanshade::viewer
