/* The tracker of touch_tracker.h. It is that of localize/live of acoustic-fem: contacts.py cuts frames into contacts,
 * joined_contacts.py joins these into touches, pressure_course.py looks at the pressure, touches.py says where. */
#include "touch_compiler.h"
#include "touch_tracker.h"

#include <math.h>
#include <string.h>

#include "touch_tracker_tables.h"

typedef enum { UNKNOWN, BEGINS, GOES_ON, BEAT, OVER } part;

/* The mean pressure of a decision, of so many of the newest ones, from the oldest on. */
static float pressure(const touch_tracker *tracker, int count, int k)
{
    int place = tracker->newest - (count - 1 - k);
    if (place < 0) place += TOUCH_TRACKER_REMEMBERED;
    return tracker->course[place];
}

static void remember(touch_tracker *tracker, const touch_decision *decision, uint32_t since)
{
    const int is_known = decision->state != TOUCH_UNREADABLE;
    if (!is_known || since == 0 || since >= TOUCH_HOP + TOUCH_HOP / 2) tracker->known = 0;
    if (!is_known) return;
    tracker->newest = (tracker->newest + 1) % TOUCH_TRACKER_REMEMBERED;
    tracker->course[tracker->newest] = decision->mean;
    if (tracker->known < TOUCH_TRACKER_REMEMBERED) tracker->known++;
}

/* Decisions from before the contact until now of which the pressure is known; 0 where that is not so. */
static int seen(const touch_tracker *tracker)
{
    const uint32_t count = tracker->hops + TOUCH_TRACKER_BEFORE;
    return count <= (uint32_t)tracker->known ? (int)count : 0;
}

/* Where the foot of a wave lies: the lowest before the contact. */
static int foot_of(const touch_tracker *tracker, int count)
{
    int foot = 0;
    for (int k = 1; k < TOUCH_TRACKER_BEFORE; k++)
        if (pressure(tracker, count, k) < pressure(tracker, count, foot)) foot = k;
    return foot;
}

static void wave_take(touch_wave *wave, int is_known, float value, int in_contact)
{
    const int is_there = is_known && wave->is_known;
    const float height = value - wave->foot;
    if (is_there && in_contact && height > wave->peak) {
        wave->peak = height;
        wave->fallen = 0;
    } else if (wave->fallen > 0 || !is_there || height < TOUCH_TRACKER_HELD_FRACTION * wave->peak) {
        wave->fallen++;
    }
    if (!is_there || height < TOUCH_TRACKER_RESTS * wave->peak) wave->rests++;
}

static void wave_begin(const touch_tracker *tracker, touch_wave *wave)
{
    const int count = seen(tracker);
    memset(wave, 0, sizeof *wave);
    if (count == 0) return;
    const int foot = foot_of(tracker, count);
    wave->is_known = 1;
    wave->foot = pressure(tracker, count, foot);
    for (int k = foot; k < count; k++) wave_take(wave, 1, pressure(tracker, count, k), 1);
}

/* First large change of the pressure: above 0 for a rise, below 0 for a fall; 0 where it is not sure or not known. */
static float stroke_of(const touch_tracker *tracker, float level)
{
    const int count = seen(tracker);
    float rise = 0.0f, fall = 0.0f, lowest = INFINITY, highest = -INFINITY, stroke = 0.0f;
    for (int k = 0; k < count; k++) {
        const float value = pressure(tracker, count, k);
        lowest = fminf(lowest, value);
        highest = fmaxf(highest, value);
        rise = fmaxf(rise, value - lowest);
        fall = fmaxf(fall, highest - value);
    }
    const float large = fmaxf(rise, fall) / 3.0f;
    lowest = INFINITY;
    highest = -INFINITY;
    for (int k = 0; k < count; k++) {
        const float value = pressure(tracker, count, k);
        lowest = fminf(lowest, value);
        highest = fmaxf(highest, value);
        const int rises = value - lowest > large, falls = highest - value > large;
        if (!rises && !falls) continue;
        stroke = falls ? -fall : rise;
        break;
    }
    return fabsf(stroke) >= TOUCH_TRACKER_SURELY * level ? stroke : 0.0f;
}

/* Decisions after which the pressure, from its peak at a place on and in a direction, first falls to a fraction of it;
 * as many as there are where it does not. */
static float falls_to(const touch_tracker *tracker, int count, int foot, int peak, int step, float fraction)
{
    const float base = pressure(tracker, count, foot), height = pressure(tracker, count, peak) - base;
    const float level = fraction * height;
    const int last = step > 0 ? count - 1 : foot;
    float before = height;
    int k = 0;
    for (int place = peak; k <= (last - peak) * step; place += step, k++) {
        const float here = pressure(tracker, count, place) - base;
        if (here < level) return (float)k - (level - here) / (before - here);
        before = here;
    }
    return (float)k;
}

/* 1 if the pressure goes up and down slowly, without staying up, as a beat of a pulse does; -1 before it has fallen. */
static int is_round(const touch_tracker *tracker)
{
    const int count = seen(tracker);
    if (count == 0) return 0;
    const int foot = foot_of(tracker, count);
    int peak = foot;
    for (int k = foot; k < count; k++)
        if (pressure(tracker, count, k) > pressure(tracker, count, peak)) peak = k;
    const float base = pressure(tracker, count, foot), height = pressure(tracker, count, peak) - base;
    int has_fallen = 0;
    for (int k = peak; k < count; k++)
        if (pressure(tracker, count, k) - base <= 0.5f * height) has_fallen = 1;
    if (!has_fallen) return -1;
    const float rise = 2.0f * falls_to(tracker, count, foot, peak, -1, 0.5f);
    const float top =
        falls_to(tracker, count, foot, peak, -1, 0.9f) + falls_to(tracker, count, foot, peak, 1, 0.9f);
    return rise >= TOUCH_TRACKER_SLOW && top <= TOUCH_TRACKER_ROUNDNESS * rise;
}

/* What a decision means for contacts: one that begins ends that before it. */
static part cut(touch_tracker *tracker, const touch_decision *decision)
{
    const uint32_t since = decision->sample - tracker->last_touched;
    const int is_apart = !tracker->has_touched || since == 0 || since > TOUCH_TRACKER_PAUSE;
    if (decision->state != TOUCH_TOUCHED) {
        if (is_apart) tracker->has_touched = 0;
        return is_apart ? OVER : GOES_ON;
    }
    const int has_fallen = tracker->least < TOUCH_TRACKER_FALLEN * tracker->loudest;
    const int rises = has_fallen && decision->level > TOUCH_TRACKER_RISEN * tracker->least;
    tracker->last_touched = decision->sample;
    tracker->has_touched = 1;
    tracker->length++;
    if (is_apart || rises || tracker->length > TOUCH_TRACKER_LONGEST) {
        tracker->loudest = tracker->least = decision->level;
        tracker->length = 1;
        return BEGINS;
    }
    if (decision->level > tracker->loudest) tracker->loudest = tracker->least = decision->level;
    tracker->least = fminf(tracker->least, decision->level);
    return GOES_ON;
}

static int largest_of(const float *values)
{
    int best = 0;
    for (int point = 1; point < TOUCH_POINTS; point++)
        if (values[point] > values[best]) best = point;
    return best;
}

static void evidence_take(touch_evidence *evidence, const touch_observation *frame)
{
    for (int point = 0; point < TOUCH_POINTS; point++)
        evidence->sum[point] += frame->level * frame->log_probability[point];
    evidence->levels += frame->level;
    if (frame->level < evidence->loudest) return;
    evidence->loudest = frame->level;
    memcpy(evidence->of_loudest, frame->log_probability, sizeof evidence->of_loudest);
}

/* Log-probability of a point by all frames, up to a constant. The new samples of each frame count by its level, and the
 * samples that the first frame holds from before by the loudest frame. */
static float evidence_for(const touch_evidence *evidence, int point)
{
    const float share = (float)TOUCH_HOP / (float)TOUCH_FRAME / evidence->loudest;
    const float before = fmaxf(0.0f, 1.0f - share * evidence->levels);
    return share * evidence->sum[point] + before * evidence->of_loudest[point];
}

static float probability_of(const touch_evidence *evidence, int point)
{
    float most = -INFINITY, sum = 0.0f;
    for (int k = 0; k < TOUCH_POINTS; k++) most = fmaxf(most, evidence_for(evidence, k));
    for (int k = 0; k < TOUCH_POINTS; k++) sum += expf(evidence_for(evidence, k) - most);
    return expf(evidence_for(evidence, point) - most) / sum;
}

/* The belief about the point after a frame: a finger stays, goes on to a neighbour on its line, or lands anywhere. */
static void believe(touch_tracker *tracker, const float *log_probability, float weight)
{
    float before[TOUCH_POINTS], sum = 0.0f, total = 0.0f;
    const float most = log_probability[largest_of(log_probability)];
    for (int point = 0; point < TOUCH_POINTS; point++) {
        before[point] = tracker->has_belief ? tracker->belief[point] : 1.0f / (float)TOUCH_POINTS;
        sum += before[point];
    }
    for (int point = 0; point < TOUCH_POINTS; point++) {
        float prior = before[point];
        if (tracker->has_belief) {
            prior = touch_stays[point] * before[point] + TOUCH_TRACKER_JUMP / (float)TOUCH_POINTS * sum;
            for (int k = 0; k < TOUCH_NEIGHBOURS; k++) {
                const int from = touch_neighbours[point][k];
                if (from >= 0) prior += touch_steps_on[from] * before[from];
            }
        }
        tracker->belief[point] = prior * expf(weight * (log_probability[point] - most));
        total += tracker->belief[point];
    }
    for (int point = 0; point < TOUCH_POINTS; point++) tracker->belief[point] /= total;
    tracker->has_belief = 1;
}

/* Report at the newest decision what the frame that ends at a sample was the first to show. */
static void tell(touch_tracker *tracker, touch_kind kind, uint32_t first)
{
    if (tracker->told >= TOUCH_EVENTS_AT_ONCE) return;
    touch_event *event = &tracker->events[tracker->told++];
    event->sample = tracker->sample;
    event->touch = tracker->number;
    event->kind = kind;
    event->point = tracker->point + 1;
    event->probability = probability_of(&tracker->evidence, tracker->point);
    event->level = tracker->touch_level;
    event->latency = (float)(tracker->sample - first + TOUCH_HOP) * 1e-3f + tracker->delay;
}

static void come_down(touch_tracker *tracker, int point)
{
    tracker->number++;
    tracker->point = point;
    tell(tracker, TOUCH_DOWN, tracker->first);
}

/* A contact that was too short for its frames to agree. */
static void come_down_late(touch_tracker *tracker)
{
    const int best = largest_of(tracker->belief);
    if (tracker->point < 0 && tracker->belief[best] >= TOUCH_TRACKER_LIKELY) come_down(tracker, best);
}

/* The next frame of a touch: where it is now. */
static void follow(touch_tracker *tracker, const touch_observation *frame)
{
    memmove(tracker->named + 1, tracker->named, sizeof tracker->named - sizeof tracker->named[0]);
    tracker->named[0] = frame->point;
    tracker->count++;
    tracker->touch_level = frame->level;
    tracker->touch_loudest = fmaxf(tracker->touch_loudest, frame->level);
    evidence_take(&tracker->evidence, frame);
    const float filled = fminf((float)(tracker->count * TOUCH_HOP) / (float)TOUCH_FRAME, 1.0f);
    const float share = (float)TOUCH_HOP / (float)TOUCH_FRAME * frame->level / tracker->touch_loudest;
    believe(tracker, frame->log_probability, share * filled * filled);
    const int best = largest_of(tracker->belief);
    int agree = tracker->count >= TOUCH_TRACKER_AGREE;
    for (int k = 0; k < TOUCH_TRACKER_AGREE; k++) agree = agree && tracker->named[k] == best;
    if (tracker->point < 0) {
        const int is_likely = tracker->count >= TOUCH_TRACKER_HELD && tracker->belief[best] >= TOUCH_TRACKER_LIKELY;
        if (agree || is_likely) come_down(tracker, best);
        return;
    }
    if (best == tracker->point) {
        tracker->other = 0;
        return;
    }
    if (tracker->other++ == 0) {
        memset(&tracker->elsewhere, 0, sizeof tracker->elsewhere);
        tracker->other_first = frame->sample;
    }
    evidence_take(&tracker->elsewhere, frame);
    if (tracker->other < TOUCH_TRACKER_HELD || !agree) return;
    const float more = evidence_for(&tracker->elsewhere, best) - evidence_for(&tracker->elsewhere, tracker->point);
    if (more < TOUCH_TRACKER_MOVED) return;
    tracker->point = best;
    tracker->other = 0;
    tell(tracker, TOUCH_MOVED, tracker->other_first);
}

static void end(touch_tracker *tracker)
{
    touch_held *touch = &tracker->touch;
    if (!touch->is_there || touch->has_ended) return;
    touch->has_ended = 1;
    come_down_late(tracker);
    if (tracker->point >= 0) tell(tracker, TOUCH_UP, touch->last);
}

/* Frames of the touch that no call before has had. */
static void more(touch_tracker *tracker, part kind, const touch_observation *frames, int count, int is_new_contact)
{
    touch_held *touch = &tracker->touch;
    if (!touch->is_there || touch->has_ended) return;
    if (is_new_contact) tracker->count = tracker->other = 0;
    for (int k = 0; k < count; k++) {
        touch->level = fmaxf(touch->level, frames[k].level);
        follow(tracker, &frames[k]);
    }
    touch->last = frames[count - 1].sample;
    touch->was_quiet = 0;
    if (kind == BEAT && tracker->point >= 0) tell(tracker, TOUCH_BEAT, frames[0].sample);
}

/* Whether no point is likelier than that of the touch by a ratio, by the mean of the frames that wait. */
static int is_at_touch(const touch_tracker *tracker)
{
    const int own = largest_of(tracker->evidence.sum);
    float most = -INFINITY, there = 0.0f;
    for (int point = 0; point < TOUCH_POINTS; point++) {
        float sum = 0.0f;
        for (int k = 0; k < tracker->waiting; k++) sum += tracker->pending[k].log_probability[point];
        most = fmaxf(most, sum);
        if (point == own) there = sum;
    }
    return (most - there) / (float)tracker->waiting < TOUCH_TRACKER_OTHER_POINT;
}

/* Whether the next beat of a pulse may begin at a sample. */
static int may_beat(const touch_held *touch, uint32_t sample)
{
    const uint32_t since = sample - touch->beat;
    return touch->is_round != 0 && since <= TOUCH_TRACKER_LONGEST_BEAT &&
           (float)(touch->wave.rests * TOUCH_HOP) <= TOUCH_TRACKER_REST * (float)since;
}

/* What the contact that has begun is; UNKNOWN where that is not known yet. */
static part kind_of(const touch_tracker *tracker, int is_over)
{
    const touch_held *touch = &tracker->touch;
    const touch_wave *wave = &touch->wave;
    const uint32_t first = tracker->pending[0].sample;
    if (!touch->is_there || !touch->goes_up || first - touch->begin > TOUCH_TRACKER_LONGEST_HOLD) return BEGINS;
    if (tracker->waiting < TOUCH_TRACKER_AGREE && !is_over) return UNKNOWN;
    float level = 0.0f;
    for (int k = 0; k < tracker->waiting; k++) level = fmaxf(level, tracker->pending[k].level);
    const float stroke = stroke_of(tracker, level);
    /* A release: the level of a frame shows one only when the pressure has fallen. */
    if (stroke < 0.0f && (wave->fallen <= TOUCH_TRACKER_BEFORE || is_at_touch(tracker))) return GOES_ON;
    /* What is left of the touch: nothing has moved. */
    if (stroke == 0.0f && !touch->was_quiet && seen(tracker) > 0 && level < TOUCH_TRACKER_TAIL * touch->level) return GOES_ON;
    if (touch->has_ended || stroke <= 0.0f) return BEGINS;
    if (wave->fallen == 0 && stroke < TOUCH_TRACKER_TREMOR * wave->peak) return GOES_ON;
    if (touch->is_round != 1 || !may_beat(touch, first) || !is_at_touch(tracker)) return BEGINS;
    const int round = is_round(tracker);
    if (round < 0 && !is_over && tracker->waiting < TOUCH_TRACKER_WAIT) return UNKNOWN;
    if (round == 0 || level <= TOUCH_TRACKER_BEAT_LEVEL * touch->level ||
        level * TOUCH_TRACKER_BEAT_LEVEL >= touch->level)
        return BEGINS;
    return first - touch->beat >= TOUCH_TRACKER_SHORTEST_BEAT ? BEAT : GOES_ON;
}

static void settle(touch_tracker *tracker, int is_over)
{
    touch_held *touch = &tracker->touch;
    const part kind = tracker->waiting > 0 ? kind_of(tracker, is_over) : UNKNOWN;
    const int count = tracker->waiting;
    if (kind == UNKNOWN) return;
    tracker->waiting = 0;
    if (kind == BEGINS) {
        end(tracker);
        memset(touch, 0, sizeof *touch);
        touch->is_there = touch->is_first_contact = 1;
        touch->is_round = -1;
        touch->begin = touch->beat = touch->last = tracker->first = tracker->pending[0].sample;
        wave_begin(tracker, &touch->wave);
        memset(&tracker->evidence, 0, sizeof tracker->evidence);
        tracker->point = -1;
        tracker->touch_loudest = 0.0f;
        tracker->has_belief = 0;
    } else if (kind == BEAT) {
        touch->beat = tracker->pending[0].sample;
        wave_begin(tracker, &touch->wave);
    }
    more(tracker, kind, tracker->pending, count, 1);
}

static void contact_over(touch_tracker *tracker)
{
    settle(tracker, 1);
    if (tracker->touch.is_there) {
        tracker->touch.is_first_contact = 0;
        if (tracker->in_contact && !tracker->touch.has_ended) come_down_late(tracker);
    }
    tracker->in_contact = 0;
}

static void look_at_pressure(touch_tracker *tracker)
{
    touch_held *touch = &tracker->touch;
    if (!touch->is_there || tracker->waiting > 0) return;
    wave_take(&touch->wave, tracker->known > 0, tracker->course[tracker->newest], tracker->in_contact);
    if (touch->is_first_contact && tracker->hops <= TOUCH_TRACKER_BEFORE)
        touch->goes_up = stroke_of(tracker, touch->level) > 0.0f;
    if (touch->goes_up && touch->is_round != 1) touch->is_round = is_round(tracker);
}

/* Whether the touch goes on without a contact: the pressure is still there, or the next beat may come. */
static int stays(touch_tracker *tracker)
{
    touch_held *touch = &tracker->touch;
    if (!touch->is_there || !touch->goes_up || tracker->sample - touch->begin > TOUCH_TRACKER_LONGEST_HOLD) return 0;
    if (touch->wave.fallen > 0) return may_beat(touch, tracker->sample);
    touch->last = tracker->sample;
    return 1;
}

static void observe(touch_observation *frame, const touch_decision *decision)
{
    frame->sample = decision->sample;
    frame->level = decision->level;
    frame->point = decision->point - 1;
    for (int point = 0; point < TOUCH_POINTS; point++)
        frame->log_probability[point] = logf(fmaxf(decision->posterior[point], TOUCH_TRACKER_LEAST));
}

void touch_tracker_init(touch_tracker *tracker, float delay)
{
    memset(tracker, 0, sizeof *tracker);
    tracker->delay = delay;
    tracker->point = -1;
}

int touch_tracker_take(touch_tracker *tracker, const touch_decision *decision, touch_event *events)
{
    const uint32_t since = tracker->has_sample ? decision->sample - tracker->sample : 0;
    tracker->events = events;
    tracker->told = 0;
    tracker->sample = decision->sample;
    tracker->has_sample = 1;
    if (since == 0 || since > TOUCH_TRACKER_LONGEST_HOLD) {
        settle(tracker, 1);
        end(tracker);
        tracker->touch.is_there = 0;
    }
    remember(tracker, decision, since);
    const part found = cut(tracker, decision);
    tracker->hops = found == BEGINS ? 1 : tracker->hops + 1;
    if (found != GOES_ON) contact_over(tracker);
    if (decision->state == TOUCH_NONE) tracker->touch.was_quiet = 1;
    if (decision->state == TOUCH_TOUCHED) {
        if (found == BEGINS) tracker->in_contact = 1;
        if (found == BEGINS || tracker->waiting > 0) {
            observe(&tracker->pending[tracker->waiting++], decision);
            settle(tracker, 0);
        } else {
            observe(&tracker->pending[0], decision);
            more(tracker, GOES_ON, tracker->pending, 1, 0);
        }
    }
    look_at_pressure(tracker);
    if (!tracker->in_contact && !stays(tracker)) end(tracker);
    return tracker->told;
}
