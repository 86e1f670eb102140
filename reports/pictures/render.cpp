#include "isobench/reports/pictures/render.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "isobench/datasets/formats/vtk_messages.h"
#include "isobench/foundation/error.h"

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

vtkSmartPointer<vtkPoints> to_vtk(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& shift) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const Eigen::Vector3d place = positions[n] + shift;
    points->SetPoint(static_cast<vtkIdType>(n), place.data());
  }
  return points;
}

vtkSmartPointer<vtkDoubleArray> to_vtk(const std::vector<double>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

vtkSmartPointer<vtkPolyData> to_vtk(const Scene& scene) {
  const TriangleMesh& mesh = *scene.mesh;
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(to_vtk(mesh.vertices, Eigen::Vector3d::Zero()));
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(to_vtk(scene.values));
  data->GetPointData()->SetScalars(to_vtk(scene.vertex_values));
  return data;
}

// The colour bar begins at this share of the width.
constexpr double bar_from = 0.83;

// Viridis: its steps look even, also to colour-blind readers. Low values are dark.
vtkSmartPointer<vtkColorTransferFunction> colours(const Scene& scene) {
  auto scale = vtkSmartPointer<vtkColorTransferFunction>::New();
  const auto at = [&scene](double share) { return scene.low + share * (scene.high - scene.low); };
  scale->AddRGBPoint(at(0.0), 0.267, 0.005, 0.329);
  scale->AddRGBPoint(at(0.25), 0.229, 0.322, 0.546);
  scale->AddRGBPoint(at(0.5), 0.128, 0.567, 0.551);
  scale->AddRGBPoint(at(0.75), 0.369, 0.789, 0.383);
  scale->AddRGBPoint(at(1.0), 0.993, 0.906, 0.144);
  return scale;
}

vtkSmartPointer<vtkActor> actor_of(const Scene& scene, vtkScalarsToColors* scale) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(to_vtk(scene));
  mapper->SetLookupTable(scale);
  if (scene.vertex_values.empty())
    mapper->SetScalarModeToUseCellData();
  else
    mapper->SetScalarModeToUsePointData();
  mapper->SetScalarVisibility(scene.values.empty() && scene.vertex_values.empty() ? 0 : 1);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.85, 0.85, 0.82);
  actor->GetProperty()->SetEdgeVisibility(scene.edges ? 1 : 0);
  actor->GetProperty()->SetEdgeColor(0.1, 0.1, 0.1);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

// Points as small balls, moved a little towards the eye so that the surface does not hide them.
vtkSmartPointer<vtkActor> points_of(const Scene& scene, const View& view, vtkScalarsToColors* scale) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk(scene.points, 0.01 * view.half_height * view.towards.normalized()));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n) cells->InsertNextCell({n});
  data->SetVerts(cells);
  data->GetPointData()->SetScalars(to_vtk(scene.point_values));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(scale);
  mapper->SetScalarVisibility(scene.point_values.empty() ? 0 : 1);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.27, 0.55);
  actor->GetProperty()->SetPointSize(static_cast<float>(scene.point_size));
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

// The outline of one triangle, moved towards the eye so that nothing hides it.
vtkSmartPointer<vtkActor> outline_of(const Scene& scene, const View& view) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const Triangle& triangle = scene.mesh->triangles[*scene.outlined];
  const Eigen::Vector3d lift = 0.9 * view.eye_distance * view.towards.normalized();
  lines->InsertNextCell(4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d corner = scene.mesh->vertices[triangle[i % 3]] + lift;
    lines->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.1, 0.1);
  actor->GetProperty()->SetLineWidth(3.0F);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkScalarBarActor> bar_of(const Scene& scene, vtkScalarsToColors* scale) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(scale);
  bar->SetTitle(scene.legend.c_str());
  bar->SetVerticalTitleSeparation(10);
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.2f");
  bar->SetOrientationToVertical();
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(0.1, 0.1);
  bar->SetWidth(0.6);
  bar->SetHeight(0.8);
  for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetColor(0.0, 0.0, 0.0);
    text->SetFontSize(14);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  return bar;
}

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
  const auto scale = colours(scene);
  if (scene.mesh != nullptr && !scene.mesh->triangles.empty()) renderer->AddActor(actor_of(scene, scale));
  if (!scene.points.empty()) renderer->AddActor(points_of(scene, view, scale));
  if (scene.outlined) renderer->AddActor(outline_of(scene, view));
  renderer->SetViewport(0.0, 0.0, bar_from, 1.0);
  vtkNew<vtkRenderer> strip;
  strip->SetBackground(1.0, 1.0, 1.0);
  strip->SetViewport(bar_from, 0.0, 1.0, 1.0);
  if (!scene.legend.empty()) strip->AddActor2D(bar_of(scene, scale));
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
