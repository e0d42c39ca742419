// tamis-lab contacts: `tamis contacts`, by a method of the caller's choice.
#include "command/verbs/contacts.hpp"
#include "paper/command/method_options.hpp"
#include "paper/command/verbs.hpp"
#include "paper/detector.hpp"

namespace tamis::lab {
namespace {

class ContactsByMethod final : public cli::Contacts {
 public:
  const char* examples() const override {
    return "  tamis-lab contacts cloth1.ply cloth2.ply\n"
           "  tamis-lab contacts cloth1.ply cloth2.ply --method paper-sat --bounding-volume aabb";
  }
  void declare(cli::OptionList& options) override {
    Contacts::declare(options);
    options.add_text("--method", method_, kMethodHelp).shown_as("NAME");
    options.add_text("--bounding-volume", bounding_volume_, kBoundingVolumeHelp).shown_as("NAME");
  }
  int run() override {
    options_of({}, method_, bounding_volume_);  // before any file is read
    return Contacts::run();
  }

 private:
  Detector detector_for(Mesh mesh, tamis::Options options) const override {
    return make_detector(std::move(mesh), options_of(options, method_, bounding_volume_));
  }

  std::string method_ = "paper", bounding_volume_ = kDefaultBoundingVolume;
};

}  // namespace

std::unique_ptr<cli::Verb> make_contacts() { return std::make_unique<ContactsByMethod>(); }

}  // namespace tamis::lab
