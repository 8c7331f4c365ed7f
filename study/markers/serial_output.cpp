// A byte a marker, its code, to a serial device: what boxes for TTL triggers take.
#include "oc_core/base/serial_port.h"
#include "study/markers/marker_output.h"

namespace ocelli {
namespace {

class SerialMarkers : public MarkerOutput {
 public:
  SerialMarkers(const SerialPlace& place, const std::string& where) : port_(place, where) {}

  void send(const Marker& marker) override { ++(port_.send(marker.code.code) ? counts_.sent : counts_.lost); }
  MarkerCounts counts() const override { return counts_; }

 private:
  SerialPort port_;
  MarkerCounts counts_{};
};

std::unique_ptr<MarkerOutput> openSerial(const std::string& text) {
  const std::string where = "--markers serial:" + text;
  return std::make_unique<SerialMarkers>(serialPlaceFromText(text, where), where);
}

}  // namespace

MarkerOutputKind serialOutput() {
  return {"serial", "serial:DEVICE[,BAUD]",
          "a byte for each marker, its code; 115200 bits a second where no rate is given", openSerial};
}

}  // namespace ocelli
