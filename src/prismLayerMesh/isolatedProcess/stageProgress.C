/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stageProgress.H"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::chrono::steady_clock progressClock;


//- A thread that calls a function once in an interval [s]
class repeater
{
    std::mutex lock_;
    std::condition_variable ended_;
    bool isEnding_ = false;
    std::thread thread_;

public:

    repeater(const double interval, const std::function<void()>& call)
    :
        thread_([=]()
        {
            const std::chrono::duration<double> length(interval);
            std::unique_lock<std::mutex> guard(lock_);
            while (!ended_.wait_for(guard, length, [=]() { return isEnding_; }))
            {
                call();
            }
        })
    {}

    ~repeater()
    {
        {
            const std::lock_guard<std::mutex> guard(lock_);
            isEnding_ = true;
        }
        ended_.notify_all();
        thread_.join();
    }
};


//- Who listens, and the last step that was told
struct progressState
{
    std::atomic<bool> isHeard{false};
    std::mutex lock;
    std::function<void(const progressStep&)> listener;
    double interval = 0;
    progressStep last{"", 0, 0};
    progressClock::time_point heard;
    std::map<std::string, loopAtBound> loops;
    std::unique_ptr<repeater> repeated;
};

} // End anonymous namespace


static progressState& state()
{
    static progressState all;

    return all;
}


//- Calls the listener if the interval has passed. The lock is held.
static void pass(progressState& all)
{
    const auto now = progressClock::now();

    const std::chrono::duration<double> interval(all.interval);

    if (all.listener && now - all.heard >= interval)
    {
        all.heard = now;
        all.listener(all.last);
    }
}


//- Tells the last step again: the stage is still at it
static void tellSameProgress()
{
    progressState& all = state();
    const std::lock_guard<std::mutex> guard(all.lock);
    pass(all);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void listenToProgress
(
    std::function<void(const progressStep&)> listener,
    const double interval
)
{
    progressState& all = state();
    all.repeated.reset();
    if (listener)
    {
        all.repeated.reset(new repeater(interval, tellSameProgress));
    }

    const std::lock_guard<std::mutex> guard(all.lock);
    all.isHeard = bool(listener);
    all.listener = std::move(listener);
    all.interval = interval;
    all.last = progressStep{"", 0, 0};
    all.heard = progressClock::time_point();
    all.loops.clear();
}


void forgetProgress()
{
    // Another thread may have had the lock when the process was copied
    state().isHeard = false;
}


void tellProgress(const char* what, const label done, const label total)
{
    progressState& all = state();

    if (all.isHeard)
    {
        const std::lock_guard<std::mutex> guard(all.lock);
        all.last = progressStep{what, done, total};
        pass(all);
    }
}


void tellBound(const char* what, const label bound)
{
    progressState& all = state();

    if (all.isHeard)
    {
        const std::lock_guard<std::mutex> guard(all.lock);
        ++all.loops.emplace(what, loopAtBound{what, bound, 0})
            .first->second.count;
    }
}


std::vector<loopAtBound> takeLoopsAtBound()
{
    progressState& all = state();
    const std::lock_guard<std::mutex> guard(all.lock);

    std::vector<loopAtBound> loops;
    for (const auto& loop : all.loops)
    {
        loops.push_back(loop.second);
    }
    all.loops.clear();

    return loops;
}

} // End namespace Foam

// ************************************************************************* //
