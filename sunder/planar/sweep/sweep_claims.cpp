#include <sunder/planar/sweep/sweep_claims.h>

#include <cstdint>
#include <vector>

namespace sunder::planar {

void write_sweep(ClaimsWriter& file, std::string_view claim, const SweepEvents& events) {
  file.begin_claims();
  file.begin_claim(claim);
  file.begin_list("events");
  std::vector<std::uint32_t> event;
  for (std::size_t k = 0; k < events.size(); ++k) {
    event.assign({events.at[k], events.below[k]});
    event.insert(event.end(), events.goes_on(k).begin(), events.goes_on(k).end());
    file.add_list(event);
  }
  file.end_list();
  file.end_claim();
}

}  // namespace sunder::planar
