// tamis-lab bench: the rows of `tamis bench` for several methods, whose answers are compared.
#include "command/verbs/bench.hpp"
#include "paper/command/method_options.hpp"
#include "paper/command/verbs.hpp"
#include "paper/detector.hpp"

namespace tamis::lab {
namespace {

class BenchOfMethods final : public cli::Bench {
 public:
  const char* examples() const override {
    return "  tamis-lab bench cloth1.ply cloth2.ply --question contacts --method tamis,paper,paper-sat\n"
           "  tamis-lab bench cloth1.ply cloth2.ply --method paper --bounding-volume aabb,16-dop --out volumes.csv\n\n"
           "Every combination of the lists is a row; 'tamis bench --help' explains them.\n"
           "Exit code 1: two rows of the same question and step differ in their answer.";
  }

 private:
  void declare_ways(cli::OptionList& options) override {
    options.add_names("--method", methods_, kMethodHelp);
    options.add_names("--bounding-volume", volumes_, kBoundingVolumeHelp);
  }

  std::vector<cli::BenchmarkWay> ways() const override {
    std::vector<cli::BenchmarkWay> ways;
    for (const std::string& method : methods_)
      for (const std::string& volume : volumes_) {
        const Options chosen = options_of({}, method, volume);
        const bool has_volume = chosen.method == Method::paper;
        if (!has_volume && volume != volumes_.front()) continue;
        ways.push_back({{{"method", method}, {"bounding_volume", has_volume ? volume : "own"}},
                        [=](const Mesh& mesh, const tamis::Options& given) {
                          return make_detector(mesh, options_of(given, method, volume));
                        }});
      }
    return ways;
  }

  std::vector<std::string> methods_{"paper"}, volumes_{kDefaultBoundingVolume};
};

}  // namespace

std::unique_ptr<cli::Verb> make_bench() { return std::make_unique<BenchOfMethods>(); }

}  // namespace tamis::lab
