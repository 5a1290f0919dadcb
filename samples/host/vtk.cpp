// A host in VTK 9, in one file: the organ is an actor of VTK's with VTK's light and material, its shader has lapfx's
// blood in it, and lapfx draws metal clips and smoke over the frame. The mouse turns the camera while a scene plays.
// With SECONDS it writes that frame as a PPM and shows no window; Debian's VTK wants an X display for that, too (Xvfb).
//
//     find_package(lapfx REQUIRED COMPONENTS effects)
//     find_package(VTK REQUIRED COMPONENTS InteractionStyle RenderingOpenGL2 RenderingUI glew)
//     find_package(OpenGL REQUIRED COMPONENTS GLX)
//     find_package(X11 REQUIRED)
//     add_executable(lapfx_host_vtk vtk.cpp)
//     target_link_libraries(lapfx_host_vtk PRIVATE lapfx::effects ${VTK_LIBRARIES} OpenGL::GLX X11::X11)
//     vtk_module_autoinit(TARGETS lapfx_host_vtk MODULES ${VTK_LIBRARIES})
//
// VTK's frame holds what the screen shows, sRGB. lapfx adds light, so that the organ's shader works in light and
// encodes at its end, and clips and smoke are drawn into an sRGB copy of the frame, where OpenGL decodes and encodes.
#include <lapfx/effects.h>
#include <lapfx/refine.h>
#include <lapfx/scene.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>  // VTK's own loader
#include <chrono>
#include <cstdio>
#include <glm/gtc/type_ptr.hpp>

#include <GL/glx.h>  // after VTK's headers, whose words it takes for macros

namespace {

// VTK's shaders are templates, and what follows takes the places of their marks. normalMC and vertexMC are the normal
// and the place in organ space, normalVCVSOutput is the normal in camera space, to which normalMatrix leads.
constexpr const char* vertex_names = R"(
in vec2 bleed_and_clot;
out vec2 v_blood;
out vec3 v_place, v_normal;
//VTK::Normal::Dec
)";
constexpr const char* vertex_steps = R"(
  v_blood = bleed_and_clot, v_place = vertexMC.xyz, v_normal = normalMC;
  //VTK::Normal::Impl
)";
constexpr const char* fragment_names = R"(
in vec2 v_blood;
in vec3 v_place, v_normal;
//VTK::Normal::Dec
)";
constexpr const char* fragment_steps = R"(
  LapfxBlood blood = lapfx_blood(v_blood, vec3(0.0), v_place, normalize(v_normal));
  ambientColor = mix(ambientColor, ambientIntensity * blood.color, blood.coverage * blood.opacity);
  diffuseColor = mix(diffuseColor, diffuseIntensity * blood.color, blood.coverage * blood.opacity);
  normalVCVSOutput = normalize(normalVCVSOutput - blood.coverage * (normalMatrix * blood.slope));
  //VTK::Light::Impl
  vec3 light = clamp(gl_FragData[0].rgb, 0.0, 1.0);
  gl_FragData[0].rgb = mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
)";

void require(bool holds, const char* reason, lapfx::Failure failure = lapfx::Failure::bad_input) {
    if (!holds) throw lapfx::Error(failure, lapfx::Fault{.file = "", .place = "", .reason = reason});
}

/// VTK's matrices have their rows one after another, GLM's their columns.
glm::mat4 matrix_of(vtkMatrix4x4* matrix) {
    return glm::mat4(glm::transpose(glm::make_mat4(matrix->GetData())));
}

/// VTK's window, with its context made and current.
vtkSmartPointer<vtkOpenGLRenderWindow> open_window(glm::ivec2 size, bool shown) {
    Display* const display = XOpenDisplay(nullptr);  // VTK would end the process if there is none
    require(display != nullptr, "no X display can be opened", lapfx::Failure::no_gl);
    vtkNew<vtkRenderWindow> made;
    vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(made);
    require(window != nullptr, "VTK has no window with OpenGL", lapfx::Failure::no_gl);
    window->SetDisplayId(display);
    window->SetSize(size.x, size.y);
    window->SetOffScreenRendering(shown ? 0 : 1);
    window->SetMultiSamples(0);  // smoke wants one depth a pixel
    window->SetWindowName("lapfx_host_vtk");
    window->Initialize();
    window->MakeCurrent();
    return window;
}

lapfx::Context::Function find_function(const char* name) {
    return glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name));
}

/// VTK's frame as lapfx draws into it: the same pixels in a texture that says that they are sRGB, and VTK's own depth.
/// Copying decodes nothing and changes no state, and what drawing changes is put back, so that VTK's record of the
/// state stays true.
class SrgbFrame {
  public:
    /// `draw(depth)` is called twice: first with a depth buffer to test against and no depth texture, then the other
    /// way round.
    template <typename Draw>
    void draw_into(vtkOpenGLFramebufferObject* frame, const Draw& draw) {
        const GLuint color = frame->GetColorAttachmentAsTextureObject(0)->GetHandle();
        const GLuint depth = frame->GetDepthAttachmentAsTextureObject()->GetHandle();
        const glm::ivec2 size(frame->GetLastSize()[0], frame->GetLastSize()[1]);
        if (size != size_) make(size);
        copy(color, color_);
        GLint bound = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
        glEnable(GL_FRAMEBUFFER_SRGB);
        glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, depth, 0);
        draw(0);
        glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, 0, 0);
        draw(depth);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
        copy(color_, color);
    }

  private:
    void make(glm::ivec2 size) {
        glDeleteTextures(1, &color_);
        glCreateTextures(GL_TEXTURE_2D, 1, &color_);
        glTextureStorage2D(color_, 1, GL_SRGB8_ALPHA8, size.x, size.y);
        if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, color_, 0);
        size_ = size;
    }
    void copy(GLuint from, GLuint to) const {
        glCopyImageSubData(from, GL_TEXTURE_2D, 0, 0, 0, 0, to, GL_TEXTURE_2D, 0, 0, 0, 0, size_.x, size_.y, 1);
    }

    glm::ivec2 size_{0};
    GLuint color_ = 0, framebuffer_ = 0;
};

struct Host {
    vtkOpenGLRenderWindow* window;
    lapfx::Scene scene;
    lapfx::Organ organ;
    lapfx::Effects effects;
    vtkNew<vtkRenderer> renderer;
    SrgbFrame frame;

    Host(vtkOpenGLRenderWindow* shown, char** arguments, bool wait)
        : window(shown),
          scene(lapfx::load_scene(arguments[1])),
          organ(lapfx::refine(
                    lapfx::load_organ(scene.folder / scene.organ.file, {scene.organ.scale, scene.organ.rotation}))
                    .organ),
          effects(organ, lapfx::load_preset(arguments[2]),
                  {static_cast<std::uint32_t>(scene.seed), scene.gravity, {arguments[3]}, wait}) {
        effects.set_curves(scene.curves);
        effects.set_contacts(scene.events);
        window->AddRenderer(renderer);
        renderer->AddActor(actor_of_organ());
        vtkCamera* const camera = renderer->GetActiveCamera();
        camera->SetPosition(glm::value_ptr(scene.camera.eye));
        camera->SetFocalPoint(glm::value_ptr(scene.camera.target));
        camera->SetViewUp(glm::value_ptr(scene.camera.up));
        camera->SetViewAngle(scene.camera.field_of_view);
        camera->SetClippingRange(2.0, 5000.0);
        vtkNew<vtkLight> light;  // beside the camera, as an endoscope's is
        light->SetLightTypeToHeadlight();
        light->SetPositional(true);
        light->SetConeAngle(180.0);
        renderer->AddLight(light);
        renderer->SetUseFXAA(true);
        renderer->AddObserver(vtkCommand::EndEvent, this, &Host::draw_over);
    }

    vtkNew<vtkActor> actor_of_organ() {
        vtkNew<vtkFloatArray> places, normals;  // the organ's own arrays, whose order bleed_buffer() has
        const auto count = static_cast<vtkIdType>(3 * organ.positions.size());
        for (vtkFloatArray* array : {places.Get(), normals.Get()}) array->SetNumberOfComponents(3);
        places->SetArray(glm::value_ptr(organ.positions.front()), count, 1);
        normals->SetArray(glm::value_ptr(organ.normals.front()), count, 1);
        vtkNew<vtkPoints> points;
        points->SetData(places);
        vtkNew<vtkCellArray> triangles;
        for (std::size_t i = 0; i < organ.indices.size(); i += 3)
            triangles->InsertNextCell({organ.indices[i], organ.indices[i + 1], organ.indices[i + 2]});
        vtkNew<vtkPolyData> surface;
        surface->SetPoints(points);
        surface->SetPolys(triangles);
        surface->GetPointData()->SetNormals(normals);

        vtkNew<vtkOpenGLPolyDataMapper> mapper;
        mapper->SetInputData(surface);
        mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);  // blood wants places in mm
        mapper->AddObserver(vtkCommand::UpdateShaderEvent, this, &Host::bind_blood);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->GetProperty()->SetColor(0.55, 0.33, 0.28);
        actor->GetProperty()->SetAmbient(0.1);
        actor->GetProperty()->SetSpecular(0.1);
        actor->GetProperty()->SetSpecularPower(40.0);
        vtkShaderProperty* const shaders = actor->GetShaderProperty();
        shaders->AddVertexShaderReplacement("//VTK::Normal::Dec", true, vertex_names, false);
        shaders->AddVertexShaderReplacement("//VTK::Normal::Impl", true, vertex_steps, false);
        // VTK writes #version 150 at this mark; bleeding_shader() wants 420 or later.
        shaders->AddFragmentShaderReplacement("//VTK::System::Dec", true, "#version 450 core\n", false);
        shaders->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, lapfx::bleeding_shader() + fragment_names,
                                              false);
        shaders->AddFragmentShaderReplacement("//VTK::Light::Impl", true, fragment_steps, false);
        return actor;
    }

    /// When VTK is about to draw the organ: its program is in use and its vertex array bound, which gets one attribute
    /// more. VTK makes both anew when it likes.
    void bind_blood(vtkObject*, unsigned long, void* program) {
        const auto name = static_cast<GLuint>(static_cast<vtkShaderProgram*>(program)->GetHandle());
        const GLint place = glGetAttribLocation(name, "bleed_and_clot");
        require(place >= 0, "VTK's shader does not have lapfx's blood", lapfx::Failure::runtime);
        GLint vertices = 0;
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertices);
        const auto array = static_cast<GLuint>(vertices), attribute = static_cast<GLuint>(place);
        glVertexArrayVertexBuffer(array, attribute, effects.bleed_buffer(), 0, sizeof(glm::vec2));
        glVertexArrayAttribBinding(array, attribute, attribute);
        glVertexArrayAttribFormat(array, attribute, 2, GL_FLOAT, GL_FALSE, 0);
        glEnableVertexArrayAttrib(array, attribute);
        effects.bind_bleeding();
    }

    /// When VTK has drawn everything and its framebuffer is still bound.
    void draw_over(vtkObject*, unsigned long, void*) {
        if (renderer->GetSelector() != nullptr) return;  // VTK picks: it draws numbers, not colours
        const glm::ivec2 size(window->GetSize()[0], window->GetSize()[1]);
        vtkCamera* const camera = renderer->GetActiveCamera();
        const lapfx::SceneLight& l = scene.light;
        const lapfx::View view{
            matrix_of(camera->GetModelViewTransformMatrix()),
            matrix_of(camera->GetProjectionTransformMatrix(static_cast<double>(size.x) / size.y, -1.0, 1.0)),
            {l.intensity, l.focus_distance, l.beam_angle, lapfx::Lamp{}.ambient, l.color}};
        frame.draw_into(window->GetRenderFramebuffer(), [&](GLuint depth) {
            depth == 0 ? effects.draw_metal_clips(view) : effects.draw_smoke(view, depth);
        });
    }

    void draw(double time) {
        window->MakeCurrent();
        effects.seek(time);
        window->Render();
    }
};

using Clock = std::chrono::steady_clock;

void play(Host& host) {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(host.window);
    interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
    interactor->Initialize();
    struct Player {
        Host& host;
        Clock::time_point begin = Clock::now();
        void show(vtkObject*, unsigned long, void*) {
            const std::chrono::duration<double> now = Clock::now() - begin;
            host.draw(std::min(now.count(), host.scene.duration));
        }
    } player{host};
    interactor->AddObserver(vtkCommand::TimerEvent, &player, &Player::show);
    interactor->CreateRepeatingTimer(16);  // ms
    interactor->Start();
}

void write_picture(Host& host, double time) {
    host.draw(time);
    const glm::ivec2 size(host.window->GetSize()[0], host.window->GetSize()[1]);
    vtkNew<vtkUnsignedCharArray> pixels;  // RGB, rows from below
    host.window->GetPixelData(0, 0, size.x - 1, size.y - 1, 0, pixels, 0);
    std::printf("P6\n%d %d\n255\n", size.x, size.y);
    for (int row = size.y; row-- > 0;) std::fwrite(pixels->GetPointer(3 * size.x * row), 3, size.x, stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        require(argc == 6 || argc == 7, "usage: lapfx_host_vtk SCENE PRESET CLIPS WIDTH HEIGHT [SECONDS]");
        const auto window = open_window({std::atoi(argv[4]), std::atoi(argv[5])}, argc == 6);
        const auto context = lapfx::Context::external(find_function);
        Host host(window, argv, argc == 7);
        argc == 6 ? play(host) : write_picture(host, std::atof(argv[6]));
    } catch (const lapfx::Error& error) {
        std::fprintf(stderr, "lapfx_host_vtk: %s\n", error.what());
        return error.failure() == lapfx::Failure::no_gl ? 77 : error.failure() == lapfx::Failure::bad_input ? 2 : 1;
    }
}
