"""Maps tell level and phase ratios; the fast route is the direct one; recordings are checked."""

import numpy as np
import pytest
import torch
from refusals import refused

from geometry import Kind
from localize.learned import features
from localize.learned.features import PairFeatures
from localize.signals import frames


def noise_frames(count: int, microphones: int = 2) -> np.ndarray:
    return np.random.default_rng(0).standard_normal((count, microphones, frames.FRAME))


def tone(frequency: float, level_db: float = 0.0, phase: float = 0.0) -> torch.Tensor:
    """Two microphones, the first ``level_db`` above and ``phase`` ahead of the second: (1, 2, 250)."""
    angle = 2 * np.pi * frequency * np.arange(frames.FRAME) / 1000
    return torch.tensor(np.array([[10 ** (level_db / 20) * np.cos(angle + phase), np.cos(angle)]]), dtype=torch.float32)


def wavelet_transform(x: np.ndarray) -> np.ndarray:
    """(..., 250) to (..., 64, 47) by the direct route: continue, transform, multiply by the wavelets, transform back.

    The wavelet is exp(-(2 pi b (f/f0 - 1))^2 / 2) in frequency, an analytic Morlet wavelet of b = ``BANDWIDTH``
    periods (Torrence and Compo 1998, table 1, with another scale).
    """
    last = np.repeat(x[..., -1:], features.CONTINUATION, axis=-1)
    spectrum = np.fft.fft(np.concatenate([x, last], axis=-1), features.GRID, axis=-1)
    product = spectrum[..., None, :] * features._wavelet_spectra()
    return np.fft.ifft(product, axis=-1)[..., frames.FRAME - features.TAIL : frames.FRAME]


def test_two_factors_give_the_wavelet_transform_of_the_direct_route():
    x = noise_frames(20)
    direct = wavelet_transform(x)
    analysis, synthesis = features._factors()
    real, imag = (x @ analysis @ synthesis).reshape(20, 2, 2, 64, 47).transpose(2, 0, 1, 3, 4)
    size = np.sqrt((np.abs(direct) ** 2).mean((0, 1, 3)))[:, None]
    assert (np.abs(real + 1j * imag - direct) / size).max() < 1e-6

    single = PairFeatures(2).transform(torch.from_numpy(x.astype(np.float32)))
    assert (np.abs(single[0].numpy() + 1j * single[1].numpy() - direct) / size).max() < 1e-5


def test_the_direct_route_is_a_convolution_with_a_morlet_wavelet():
    # Far above 1 Hz the circular grid plays no part: compare with the wavelet written in time.
    x = noise_frames(1, 1)[0, 0]
    row = 40
    centre = features.wavelet_frequencies()[row]
    spread = features.BANDWIDTH / centre
    continued = np.concatenate([x, np.full(features.CONTINUATION, x[-1])])
    time = np.arange(-600, 600) / 1000
    wavelet = np.exp(-0.5 * (time / spread) ** 2 + 2j * np.pi * centre * time) / (spread * np.sqrt(2 * np.pi)) / 1000
    expected = np.convolve(continued, wavelet)[600 : 600 + 500][203:250]
    assert np.abs(wavelet_transform(x)[row] - expected).max() < 1e-6 * np.abs(expected).max()


@pytest.mark.parametrize(("level", "phase"), [(0.0, 0.0), (6.0, 0.4), (-20.0, -2.0), (3.0, np.pi)])
def test_maps_of_a_tone_give_its_level_and_phase_at_its_frequency(level, phase):
    # Towards the end of the frame the repeated last sample blurs the ratio: only the first columns are compared.
    maps = PairFeatures(2)(tone(50.0, level, phase))[0, ..., :12]
    row = np.abs(features.wavelet_frequencies() - 50).argmin()
    assert maps[0, row].numpy() == pytest.approx(level, abs=0.35)
    assert maps[1, row].numpy() == pytest.approx(np.cos(phase), abs=0.06)
    assert maps[2, row].numpy() == pytest.approx(np.sin(phase), abs=0.06)
    assert abs(maps[3].mean(-1).argmax().item() - row) <= 1


@pytest.mark.parametrize(("microphones", "maps"), [(2, 4), (3, 10), (4, 19)])
def test_every_pair_has_three_maps_of_64_by_32_and_the_array_one_of_power(microphones, maps):
    made = PairFeatures(microphones)(torch.from_numpy(noise_frames(3, microphones)).float())
    assert made.shape == (3, maps, 64, 32)
    assert features.map_count(microphones) == maps


def test_a_common_gain_changes_nothing():
    x = torch.from_numpy(noise_frames(5)).float()
    maps = PairFeatures(2)
    assert torch.allclose(maps(x), maps(1e-6 * x), atol=1e-3)


def test_exchanging_the_microphones_turns_level_and_phase_round():
    x = torch.from_numpy(noise_frames(5)).float()
    one, other = PairFeatures(2)(x), PairFeatures(2)(x.flip(1))
    sign = torch.tensor([-1.0, 1.0, -1.0, 1.0])[:, None, None]
    assert torch.allclose(other, sign * one, atol=1e-4)


def test_power_runs_from_its_maximum_down_to_60_db_below():
    power = PairFeatures(2)(tone(30.0))[:, -1]
    assert power.max() == 0
    assert power.min() >= -60


def test_the_last_frame_ends_with_the_recording():
    x = torch.arange(700.0).expand(2, 3, 700)
    cut = frames.cut_frames(x)
    assert cut.shape == (2, 2, 3, 250)
    assert cut[0, :, 0, -1].tolist() == [449.0, 699.0]
    assert torch.equal(frames.cut_frames(x[..., :250])[:, 0], x[..., :250])


def test_frames_that_agree_make_a_point_more_probable_than_each_alone():
    p = torch.tensor([[[0.6, 0.4], [0.6, 0.4]]], dtype=torch.float64)
    assert frames.combined_probability(p.log())[0].tolist() == pytest.approx([0.36 / 0.52, 0.16 / 0.52])


def broken(kind: str) -> np.ndarray:
    x = noise_frames(3)
    match kind:
        case "one dimension":
            return x[0, 0]
        case "four dimensions":
            return x[None]
        case "three channels":
            return noise_frames(3, 3)
        case "short":
            return x[..., :249]
        case "nan":
            x[1, 0, 5] = np.nan
        case "infinite":
            x[2, 1, 0] = -np.inf
        case "silent":
            x[0, 1] = 0
        case "stuck":
            x[2, 0] = 1.25
    return x


@pytest.mark.parametrize(
    ("name", "kind", "words"),
    [
        ("one dimension", Kind.WRONG_TYPE, "(250,)"),
        ("four dimensions", Kind.WRONG_TYPE, "(1, 3, 2, 250)"),
        ("three channels", Kind.MISMATCH, "3 channels"),
        ("short", Kind.UNSUITABLE, "249 samples"),
        ("nan", Kind.UNSUITABLE, "channel left of signal 1 holds"),
        ("infinite", Kind.UNSUITABLE, "channel right of signal 2 holds"),
        ("silent", Kind.UNSUITABLE, "channel right of signal 0 is silent"),
        ("stuck", Kind.UNSUITABLE, "channel left of signal 2 is silent"),
    ],
)
def test_recordings_from_which_no_touch_can_be_read_are_refused(name, kind, words):
    with refused(kind, "signals") as found:
        frames.checked_signals(broken(name), ("left", "right"))
    assert words in str(found.value)


# -- the paper's maps -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("microphones", "maps"), [(2, 2), (3, 6), (4, 12)])
def test_the_papers_maps_are_level_and_phase_of_every_pair(microphones, maps):
    x = torch.from_numpy(noise_frames(3, microphones)).float()
    made, default = PairFeatures(microphones, "paper")(x), PairFeatures(microphones)(x)
    assert made.shape == (3, maps, 64, 32)
    assert features.map_count(microphones, "paper") == maps
    pairs = default[:, :-1].unflatten(1, (-1, 3))
    assert torch.allclose(made[:, 0::2], pairs[:, :, 0])
    assert torch.allclose(made[:, 1::2], torch.atan2(pairs[:, :, 2], pairs[:, :, 1]))


@pytest.mark.parametrize("phase", [np.pi - 0.02, -np.pi + 0.02, 0.0])
def test_the_mean_of_phases_beside_the_jump_lies_there_and_not_at_zero(phase):
    maps = PairFeatures(2, "paper")(tone(50.0, 0.0, phase))[0, 1, :, :12]
    row = np.abs(features.wavelet_frequencies() - 50).argmin()
    assert np.abs(np.angle(np.exp(1j * (maps[row].numpy() - phase)))).max() < 0.06


# -- the maps of rooms ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("microphones", "maps"), [(2, 8), (3, 20), (4, 38)])
def test_maps_of_rooms_are_those_of_the_frame_and_again_of_what_is_taken_out_of(microphones, maps):
    x = torch.from_numpy(noise_frames(3, microphones)).float()
    made, once = PairFeatures(microphones, "rooms")(x), PairFeatures(microphones)(x)
    assert made.shape == (3, maps, 64, 32)
    assert features.map_count(microphones, "rooms") == maps
    assert torch.allclose(made[:, : maps // 2], once)
    assert torch.allclose(made[:, maps // 2 :], once, atol=1e-4), "nothing is taken out yet"


def test_sound_that_is_the_same_at_all_microphones_is_taken_out():
    rooms = PairFeatures(3, "rooms")
    rooms.take_out(1e8 * np.kron(np.ones((3, 3)), np.eye(frames.FRAME)) + np.eye(3 * frames.FRAME))
    touch = noise_frames(4, 3)
    alone = touch - touch.mean(1, keepdims=True)  # all that can be told of it
    sound = 30 * np.random.default_rng(1).standard_normal((4, 1, frames.FRAME))
    first, second = rooms(torch.from_numpy(touch + sound)).split(10, dim=1)
    expected = PairFeatures(3)(torch.from_numpy(alone))
    assert (second - expected).abs().mean() < 0.01
    assert (first - expected).abs().mean() > 1


def test_unknown_maps_are_refused():
    with refused(Kind.OUT_OF_RANGE, "features", "levels"):
        PairFeatures(2, "levels")


# -- anywhere -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("choice", ["phasors", "paper", "rooms"])
def test_features_move_to_a_device_and_are_exported_as_one_graph_of_real_numbers(choice):
    maps = PairFeatures(2, choice).eval()
    # The device without data refuses tensors of any other: no accelerator is needed to see that all of them move.
    assert PairFeatures(2, choice).to("meta")(torch.empty(3, 2, 250, device="meta")).shape[2:] == (64, 32)

    x = torch.from_numpy(noise_frames(4)).float()
    batch = {"frames": {0: torch.export.Dim("n", min=1, max=512)}}
    graph = torch.export.export(maps, (x,), dynamic_shapes=batch)
    assert torch.equal(graph.module()(x[:3]), maps(x[:3]))
    made = [node.meta["val"] for node in graph.graph.nodes if isinstance(node.meta.get("val"), torch.Tensor)]
    assert not any(value.is_complex() for value in made)


def test_in_training_the_maps_are_the_same():
    x = torch.from_numpy(noise_frames(4, 3)).float()
    maps = PairFeatures(3, "rooms")
    assert torch.allclose(maps.train()(x), maps.eval()(x), atol=1e-4)


def test_the_rank_of_continuation_and_wavelet_leaves_1e_6_of_the_smallest_singular_values():
    analysis, _ = features._factors()
    strength = np.linalg.norm(analysis, axis=0)
    assert analysis.shape == (250, features.RANK)
    assert strength[-1] < 1e-6 * strength[0]


def test_the_fcwt_package_finds_the_same_above_its_lowest_frequencies(monkeypatch):
    fcwt = pytest.importorskip("fcwt", exc_type=ImportError)
    x = noise_frames(1, 1)[0, 0]
    continued = np.concatenate([x, np.full(features.CONTINUATION, x[-1])]).astype(np.float32)
    wavelet = fcwt.Morlet(features.BANDWIDTH)
    scales = fcwt.Scales(wavelet, fcwt.FCWT_LINFREQS, 1000, 1.0, 100.0, 64)
    frequency, found = np.zeros(64, np.float32), np.zeros((64, 500), np.complex64)
    scales.getFrequencies(frequency)
    fcwt.FCWT(wavelet, 1, False, True).cwt(continued, scales, found)
    # Its grid runs downwards and leaves out 100 Hz; its circular one of 512 samples wraps around below some 30 Hz.
    assert (frequency[0] < 99, frequency[-1]) == (True, 1.0)
    monkeypatch.setattr(features, "wavelet_frequencies", lambda: frequency.astype(float))
    ours = np.sqrt(2) * np.pi**0.25 * wavelet_transform(x)
    error = np.abs(found[:, 203:250] - ours).max(1) / np.abs(ours).max(1)
    assert error[frequency > 30].max() < 0.03
    assert error[frequency < 5].min() > 0.3
