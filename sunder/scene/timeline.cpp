#include <sunder/scene/timeline.h>

#include <utility>

namespace sunder::scene {

MomentFollower::MomentFollower(std::span<const Body> bodies, const Question& question, NearnessQuestion near)
    : meeting_(bodies, question), near_(std::move(near)) {
  if (near_.clearance) clearance_.emplace(bodies, *near_.clearance);
}

Moment MomentFollower::ask() {
  Moment moment{meeting_.bodies(), meeting_.ask(), {}};
  if (clearance_) moment.near.clearance = clearance_->ask(moment.bodies);
  if (near_.nearest) moment.near.nearest = nearest_parts(moment.bodies, near_.allowed);
  return moment;
}

void MomentFollower::practise() {
  (void)meeting_.ask();
  if (clearance_) (void)clearance_->ask(meeting_.bodies());
}

StepFollower::StepFollower(std::span<const Body> bodies, const Question& question)
    : members_(std::make_shared<const Members>(bodies, question.allowed)),
      last_(bodies.begin(), bodies.end()),
      next_(last_),
      question_(question) {}

SweptAnswer StepFollower::ask() {
  SweptAnswer answer = meeting_on_the_way(last_, next_, question_);
  for (std::uint32_t i = 0; i < members_->size(); ++i) {
    members_->part(std::span(last_), i).pose = members_->part(std::span<const Body>(next_), i).pose;
  }
  return answer;
}

}  // namespace sunder::scene
