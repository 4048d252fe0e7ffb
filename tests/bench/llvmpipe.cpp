// Mesa's llvmpipe through OSMesa: OpenGL 3.3, static buffers, a framebuffer object in its memory.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// GL's own headers come first.
#include <GL/glext.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "bench/peer_scene.hpp"
#include "bench/rival.hpp"
#include "bench/scenes.hpp"
#include "bench/shaders.hpp"
#include "scanshade/base/timer.hpp"

namespace scanshade::bench {
namespace {

/// A vertex as the buffers hold it; `centre` and `id` are of the triangle that ends with it.
struct Vertex {
    Float3 position, normal, centre;
    std::uint32_t id;
};

struct Geometry {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

Geometry shared_vertices(const Mesh& mesh) {
    Geometry out;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        out.vertices.push_back(
            {{mesh.x[v], mesh.y[v], mesh.z[v]}, {mesh.nx[v], mesh.ny[v], mesh.nz[v]}, {}, 0});
    for (const auto& corners : mesh.triangle)
        out.indices.insert(out.indices.end(), corners.begin(), corners.end());
    return out;
}

/// For what is constant over a triangle: its last corner is a vertex of its own, which carries the
/// value, and the other two are any that stand at the right place. So no vertex is lit in vain.
Geometry provoking_vertices(const Mesh& mesh) {
    Geometry out;
    std::vector<std::uint32_t> standing(mesh.vertex_count(), no_index);  // a vertex at that place
    const auto add = [&](std::uint32_t v, std::size_t triangle) {
        const std::uint32_t face = mesh.triangle_face[triangle];
        standing[v] = std::uint32_t(out.vertices.size());
        out.vertices.push_back({{mesh.x[v], mesh.y[v], mesh.z[v]},
                                mesh.face_normal[face],
                                mesh.face_centre[face],
                                std::uint32_t(triangle)});
    };
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) add(mesh.triangle[t][2], t);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        for (int corner = 0; corner < 2; ++corner) {
            const std::uint32_t v = mesh.triangle[t][std::size_t(corner)];
            if (standing[v] == no_index) add(v, t);
            out.indices.push_back(standing[v]);
        }
        out.indices.push_back(std::uint32_t(t));
    }
    return out;
}

/// Buffers on OpenGL's side.
class VertexArray {
public:
    explicit VertexArray(const Geometry& geometry) : count_(GLsizei(geometry.indices.size())) {
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        GLuint buffers[2];
        glGenBuffers(2, buffers);
        glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(geometry.vertices.size() * sizeof(Vertex)),
                     geometry.vertices.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     GLsizeiptr(geometry.indices.size() * sizeof(std::uint32_t)),
                     geometry.indices.data(), GL_STATIC_DRAW);
        const auto at = [](std::size_t bytes) {           // GL takes offsets as pointers
            return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
        };
        const std::size_t floats[] = {offsetof(Vertex, position), offsetof(Vertex, normal),
                                      offsetof(Vertex, centre)};
        for (GLuint i = 0; i < 3; ++i)
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(floats[i]));
        glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, sizeof(Vertex), at(offsetof(Vertex, id)));
        for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
    }
    void draw() const {
        glBindVertexArray(array_);
        glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    }

private:
    GLuint array_ = 0;
    GLsizei count_;
};

/// Throws with the compiler's or linker's message.
void require(GLuint object, decltype(&glGetShaderiv) get, decltype(&glGetShaderInfoLog) log,
             GLenum status) {
    GLint good = 0;
    get(object, status, &good);
    if (good) return;
    std::array<char, 4096> text{};
    log(object, GLsizei(text.size()), nullptr, text.data());
    throw std::runtime_error(fmt::format("llvmpipe refuses a shader: {}", text.data()));
}

GLuint link_program(const ShaderPair& pair) {
    const GLuint program = glCreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, &pair.vertex}, {GL_FRAGMENT_SHADER, &pair.fragment}}) {
        const GLuint shader = glCreateShader(GLenum(kind));
        const char* source = text->c_str();
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        require(shader, glGetShaderiv, glGetShaderInfoLog, GL_COMPILE_STATUS);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    require(program, glGetProgramiv, glGetProgramInfoLog, GL_LINK_STATUS);
    return program;
}

void set_uniforms(GLuint program, const PeerScene& scene) {
    glUseProgram(program);
    // A name that a program does not read has location −1, which is ignored.
    const auto at = [&](const std::string& name) {
        return glGetUniformLocation(program, name.c_str());
    };
    glUniformMatrix4fv(at("to_clip"), 1, GL_FALSE, scene.to_clip);
    glUniform4f(at("place"), scene.origin[0], scene.origin[1], scene.origin[2], scene.scale);
    glUniform3fv(at("eye"), 1, scene.eye.data());
    glUniform3fv(at("base"), 1, scene.base.data());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const PeerLight& light = scene.lights[i];
        glUniform3fv(at(fmt::format("light_position[{}]", i)), 1, light.position);
        glUniform3fv(at(fmt::format("light_diffuse[{}]", i)), 1, light.diffuse);
        glUniform3fv(at(fmt::format("light_specular[{}]", i)), 1, light.specular);
        glUniform2f(at(fmt::format("light_attenuation[{}]", i)), light.c, light.q);
    }
}

/// Colour of 8 bits and depth of 24, so that a frame needs no copying out.
class Target {
public:
    Target(int width, int height) : width_(width), height_(height) {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glGenRenderbuffers(2, buffers_);
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, buffers_[0]);
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, buffers_[1]);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("llvmpipe has no framebuffer of 8 bits with depth");
        glViewport(0, 0, width, height);
    }
    ~Target() {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(2, buffers_);
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    std::vector<std::uint32_t> read() const {
        std::vector<std::uint32_t> rows(std::size_t(width_) * std::size_t(height_));
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        return rows;
    }

private:
    void attach(GLenum attachment, GLenum format, GLuint buffer) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    }

    int width_, height_;
    GLuint framebuffer_ = 0, buffers_[2] = {};
};

class Llvmpipe final : public Rival {
public:
    explicit Llvmpipe(const Ground& ground) : ground_(ground) {
        // Read when the context is made. 0: the calling thread rasterizes, and no other.
        const int workers = ground.threads == 1 ? 0 : ground.threads;
        ::setenv("LP_NUM_THREADS", std::to_string(workers).c_str(), 1);
        ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        const int wanted[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
        context_ = OSMesaCreateContextAttribs(wanted, nullptr);
        if (context_ == nullptr || !OSMesaMakeCurrent(context_, &window_, GL_UNSIGNED_BYTE, 1, 1))
            throw std::runtime_error("OSMesa gives no OpenGL 3.3 context");
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_DITHER);
        if (ground.cull == Cull::back) glEnable(GL_CULL_FACE);
        const Mesh& mesh = *ground.scene.objects[0].mesh;
        shared_ = std::make_unique<VertexArray>(shared_vertices(mesh));
        provoking_ = std::make_unique<VertexArray>(provoking_vertices(mesh));
        id_program_ = link_program(id_shaders());
    }

    std::string about() const override {
        return fmt::format("{}, OpenGL {}", text_of(GL_RENDERER), text_of(GL_VERSION));
    }

    std::vector<std::string> prepare(const Cell& cell) override {
        if (cell.interpolation != Interpolation::perspective) return {};
        const Settings settings = settings_of(cell, ground_.cull);
        target_.reset();
        target_ = std::make_unique<Target>(cell.width, cell.height);
        width_ = std::size_t(cell.width);
        peer_ = make_peer_scene(lit_scene(ground_.scene, cell), settings);
        array_ = cell.shading == Shading::flat ? provoking_.get() : shared_.get();

        set_uniforms(id_program_, peer_);
        for (const GLuint program : programs_) glDeleteProgram(program);
        programs_.clear();
        const bool two_sided = ground_.cull == Cull::none;
        if (cell.lights == 0) {
            programs_ = {link(shaders_of(cell, two_sided, true))};
            return {"unlit"};
        }
        for (const bool squarings : {true, false})
            programs_.push_back(link(shaders_of(cell, two_sided, squarings)));
        return {"squarings", "pow"};
    }

    void draw(std::size_t way) override {
        glUseProgram(programs_[way]);
        glClearColor(peer_.background[0], peer_.background[1], peer_.background[2], 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        array_->draw();
        glFinish();
    }

    Picture picture(std::size_t way) override {
        Picture picture;
        draw(way);
        const Timer timer;
        picture.rgba = target_->read();
        picture.copy_out_ms = timer.ms();
        glUseProgram(id_program_);
        glClearColor(1, 1, 1, 1);  // no_triangle
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        provoking_->draw();
        picture.id = target_->read();
        for (auto* plane : {&picture.rgba, &picture.id}) turn_over(*plane);
        return picture;
    }

private:
    GLuint link(const ShaderPair& pair) const {
        const GLuint program = link_program(pair);
        set_uniforms(program, peer_);
        return program;
    }

    static const char* text_of(GLenum name) {
        return reinterpret_cast<const char*>(glGetString(name));
    }

    /// OpenGL's rows start below.
    void turn_over(std::vector<std::uint32_t>& plane) const {
        const std::size_t rows = plane.size() / width_;
        for (std::size_t y = 0; y < rows / 2; ++y)
            std::swap_ranges(plane.begin() + std::ptrdiff_t(y * width_),
                             plane.begin() + std::ptrdiff_t((y + 1) * width_),
                             plane.begin() + std::ptrdiff_t((rows - 1 - y) * width_));
    }

    Ground ground_;
    OSMesaContext context_ = nullptr;
    std::uint32_t window_ = 0;  // the context's own picture, which nothing is drawn into
    std::unique_ptr<VertexArray> shared_, provoking_;
    GLuint id_program_ = 0;
    std::vector<GLuint> programs_;  // [way]
    std::unique_ptr<Target> target_;
    const VertexArray* array_ = nullptr;
    PeerScene peer_{};
    std::size_t width_ = 0;
};

}  // namespace

std::unique_ptr<Rival> make_llvmpipe(const Ground& ground) {
    return std::make_unique<Llvmpipe>(ground);
}

}  // namespace scanshade::bench
