// SPDX-License-Identifier: Apache-2.0
#include "render/method.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "error.h"
#include "render/picture_memory.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

template <class AnyIntersector>
Rendering render_with(const AnyIntersector& intersector, const Scene& scene, const Method& method,
                      const NumberFormat& format, int threads, const Progress& progress) {
  if (method.pyramid) {
    PyramidOptions options = method.pyramids;
    options.threads = threads;
    options.view_vectors = format;
    return render_pyramids(scene, intersector, options, progress);
  }
  BaselineOptions options = method.sampling;
  options.threads = threads;
  options.view_vectors = format;
  return render_baseline(scene, intersector, options, progress);
}

}  // namespace

std::string Method::name() const {
  if (pyramid) return "pyramid";
  if (!sampling.jitter && sampling.grid == 1) return "point";
  return fmt::format("{}:{}", sampling.jitter ? "jitter" : "grid", sampling.grid);
}

std::int64_t Method::grid_steps() const {
  return pyramid ? std::int64_t{1} << static_cast<unsigned>(pyramids.max_level) : baseline_steps(sampling);
}

Method parse_method(std::string_view name) {
  Method method;
  if (name == "pyramid") return method;
  method.pyramid = false;
  if (name == "point") return method;
  const std::size_t colon = name.find(':');
  const std::string_view kind = name.substr(0, colon);
  if (colon != std::string_view::npos && (kind == "grid" || kind == "jitter")) {
    const std::string_view number = name.substr(colon + 1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), method.sampling.grid);
    if (error == std::errc() && end == number.data() + number.size() && method.sampling.grid >= 1 &&
        method.sampling.grid <= max_sampling_grid) {
      method.sampling.jitter = kind == "jitter";
      return method;
    }
  }
  throw UsageError(fmt::format("method {}: allowed are pyramid, point, grid:N and jitter:N with N from 1 to {}",
                               value_excerpt(name), max_sampling_grid));
}

Rendering render(const Scene& scene, const Method& method, const DatapathFormats& formats, int threads,
                 const Progress& progress) {
  if (method.pyramid) check_addressable(scene.camera.screen, method.pyramids.max_level);
  check_picture_fits(scene.camera.rendered());
  if (formats.plain()) {
    return render_with(SceneIntersector<double>(scene), scene, method, formats.view_vectors, threads, progress);
  }
  const std::unique_ptr<Intersector> intersector = make_intersector(scene, formats.intersection);
  return render_with(*intersector, scene, method, formats.view_vectors, threads, progress);
}

void check_addressable(const Screen& screen, int max_level) {
  if (addressable(screen.columns, screen.rows, max_level)) return;
  throw UsageError(
      fmt::format("{}x{} pixels at MAX_LEVEL {} have more than 2^32 grid points along a side; a smaller "
                  "screen or a lower MAX_LEVEL is allowed",
                  screen.columns, screen.rows, max_level));
}

}  // namespace pyrasim
