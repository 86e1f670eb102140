#include "isobench/reports/pictures/render.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "isobench/datasets/formats/vtk/vtk_messages.h"
#include "isobench/foundation/error.h"
#include "isobench/reports/pictures/actors.h"

namespace isobench {

namespace {

// Debian's GLEW reports an error without an X server although it has loaded all functions, so its result is ignored.
class Window : public vtkGenericOpenGLRenderWindow {
 public:
  static Window* New();  // NOLINT(readability-identifier-naming): VTK's name
  vtkTypeMacro(Window, vtkGenericOpenGLRenderWindow)

      protected : void OpenGLInitContext() override {
    vtkGenericOpenGLRenderWindow::OpenGLInitContext();
    GlewInitValid = true;
    Initialized = true;
  }
};
vtkStandardNewMacro(Window)

    [[noreturn]] void no_opengl(const std::string& what) {
  throw Error("pictures cannot be drawn: " + what +
              "; install Mesa (apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri), then make the report again");
}

// The colour bar begins at this share of the width.
constexpr double bar_from = 0.83;

template <class Writer>
std::string encoded(Writer& writer, vtkWindowToImageFilter& image) {
  writer.SetInputConnection(image.GetOutputPort());
  writer.WriteToMemoryOn();
  writer.Write();
  vtkUnsignedCharArray* bytes = writer.GetResult();
  if (bytes == nullptr) return "";
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void aim(vtkCamera* camera, const View& view) {
  const Eigen::Vector3d direction = view.towards.normalized();
  const Eigen::Vector3d eye = view.focus + view.eye_distance * direction;
  const bool steep = std::abs(direction.z()) > 0.95;
  camera->SetFocalPoint(view.focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0.0, steep ? 1.0 : 0.0, steep ? 0.0 : 1.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(view.half_height);
}

}  // namespace

// A surfaceless OpenGL context of Mesa. It is current in this thread as long as it exists.
class Renderer::Context {
 public:
  Context() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display == nullptr) no_opengl("EGL has no eglGetPlatformDisplayEXT");
    display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      no_opengl("OpenGL does not start without a display");
    }
    eglBindAPI(EGL_OPENGL_API);
    constexpr std::array<EGLint, 7> wanted = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
    constexpr std::array<EGLint, 5> small = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    constexpr std::array<EGLint, 7> version = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display_, wanted.data(), &config, 1, &found) == EGL_FALSE || found == 0) {
      no_opengl("EGL has no suitable configuration");
    }
    surface_ = eglCreatePbufferSurface(display_, config, small.data());
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
    if (eglMakeCurrent(display_, surface_, surface_, context_) == EGL_FALSE) no_opengl("OpenGL 3.2 is missing");
  }
  ~Context() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    eglTerminate(display_);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

Renderer::Renderer(int width, int height) : context_(std::make_unique<Context>()), width_(width), height_(height) {}
Renderer::~Renderer() = default;

Drawing Renderer::draw(const Scene& scene, const View& view) {
  const VtkMessages messages;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetViewport(0.0, 0.0, bar_from, 1.0);
  vtkNew<vtkRenderer> strip;
  strip->SetBackground(1.0, 1.0, 1.0);
  strip->SetViewport(bar_from, 0.0, 1.0, 1.0);
  add_actors(scene, view, *renderer, *strip);
  aim(renderer->GetActiveCamera(), view);

  vtkNew<Window> window;
  window->SetIsDirect(1);
  window->SetSupportsOpenGL(1);
  window->SetIsCurrent(true);
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetMapped(1);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(width_, height_);
  window->OpenGLInit();
  window->AddRenderer(renderer);
  window->AddRenderer(strip);
  renderer->ResetCameraClippingRange();
  // VTK puts the near plane at a fixed share of the depth. In a close view this plane is behind the triangle to be
  // shown.
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetClippingRange(0.01 * view.eye_distance, std::max(camera->GetClippingRange()[1], view.eye_distance * 2.0));
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> png;
  png->SetCompressionLevel(9);
  vtkNew<vtkJPEGWriter> jpeg;
  jpeg->SetQuality(85);
  Drawing drawing{encoded(*png, *image), encoded(*jpeg, *image)};
  if (drawing.png.empty() || drawing.jpeg.empty()) throw Error("VTK made no picture: " + messages.first_error());
  window->Finalize();
  return drawing;
}

}  // namespace isobench
