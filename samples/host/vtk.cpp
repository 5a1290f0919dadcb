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
// Light is linear: the window is an sRGB one, so that OpenGL encodes what shaders write, VTK's and lapfx's alike, and
// VTK's colours are shares of light, not sRGB. VTK has no exposure, so that the lamps are that much brighter.
#include <lapfx/effects.h>
#include <lapfx/refine.h>
#include <lapfx/scene.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
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
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>  // VTK's own loader
#include <chrono>
#include <cstdio>
#include <glm/gtc/type_ptr.hpp>

#include <GL/glx.h>  // after VTK's headers, whose words it takes for macros

namespace {

// VTK's shaders are templates, and what follows takes the places of their marks. normalMC and vertexMC are the normal
// and the place in organ space, normalVCVSOutput is the normal in camera space, which normalMatrix leads to.
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
uniform mat3 normalMatrix;
//VTK::Normal::Dec
)";
constexpr const char* fragment_steps = R"(
  LapfxBlood blood = lapfx_blood(v_blood, vec3(0.0), v_place, normalize(v_normal));
  ambientColor = mix(ambientColor, ambientIntensity * blood.color, blood.coverage * blood.opacity);
  diffuseColor = mix(diffuseColor, diffuseIntensity * blood.color, blood.coverage * blood.opacity);
  normalVCVSOutput = normalize(normalVCVSOutput - blood.coverage * (normalMatrix * blood.slope));
  //VTK::Light::Impl
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
    Display* const display = XOpenDisplay(nullptr);  // without one VTK ends the process
    require(display != nullptr, "no X display can be opened", lapfx::Failure::no_gl);
    XCloseDisplay(display);
    vtkNew<vtkRenderWindow> made;
    vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(made);
    require(window != nullptr, "VTK has no window with OpenGL", lapfx::Failure::no_gl);
    window->SetSize(size.x, size.y);
    window->SetOffScreenRendering(shown ? 0 : 1);
    window->SetUseSRGBColorSpace(true);
    window->SetMultiSamples(4);
    window->SetWindowName("lapfx_host_vtk");
    window->Initialize();
    window->MakeCurrent();
    return window;
}

lapfx::Context::Function find_function(const char* name) {
    return glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name));
}

/// A single-sampled copy of the depth of VTK's frame, which draw_smoke() reads.
class DepthCopy {
  public:
    /// Of the framebuffer that is bound to draw into. These calls change no binding, so that what VTK's own record of
    /// the state says stays true.
    GLuint take(glm::ivec2 size) {
        GLint frame = 0, depth = 0, format = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
        const auto source = static_cast<GLuint>(frame);
        glGetNamedFramebufferAttachmentParameteriv(source, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
                                                   &depth);
        glGetTextureLevelParameteriv(static_cast<GLuint>(depth), 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
        if (size != size_) make(size, static_cast<GLenum>(format));  // another format could not be copied
        glBlitNamedFramebuffer(source, framebuffer_, 0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_DEPTH_BUFFER_BIT,
                               GL_NEAREST);
        return texture_;
    }

  private:
    void make(glm::ivec2 size, GLenum format) {
        glDeleteTextures(1, &texture_);
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, format, size.x, size.y);
        if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, texture_, 0);
        glNamedFramebufferDrawBuffer(framebuffer_, GL_NONE);
        size_ = size;
    }

    glm::ivec2 size_{0};
    GLuint texture_ = 0, framebuffer_ = 0;
};

struct Host {
    vtkOpenGLRenderWindow* window;
    lapfx::Scene scene;
    lapfx::Organ organ;
    lapfx::Effects effects;
    vtkNew<vtkRenderer> renderer;
    DepthCopy depth;

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
        light->SetIntensity(scene.camera.exposure);
        renderer->AddLight(light);
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
        actor->GetProperty()->SetAmbient(0.1 * scene.camera.exposure);
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
            {l.intensity * scene.camera.exposure, l.focus_distance, l.beam_angle, lapfx::Lamp{}.ambient, l.color}};
        effects.draw_metal_clips(view);
        effects.draw_smoke(view, depth.take(size));
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
    host.window->GetPixelData(0, 0, size.x - 1, size.y - 1, 0, pixels.Get());
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
