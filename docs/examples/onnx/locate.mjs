// Locate touches with a decoder in ONNX: node locate.mjs decoder.onnx touches.csv about.json
//
// Needs onnxruntime-node, and nothing of acoustic-fem. onnxruntime-node does not show the metadata of a graph, so
// about.json holds what stands there under the key acoustic-fem. The recording is a CSV file at 1 kHz with a column of
// pressure in Pa for each microphone. Prints the time and the point of each decision, from point 1.
import { readFileSync } from "node:fs";
import { InferenceSession, Tensor } from "onnxruntime-node";

const [model, table, metadata] = process.argv.slice(2);
const about = JSON.parse(readFileSync(metadata, "utf8"));
const { stream, frame } = about;

const [head, ...rows] = readFileSync(table, "utf8").trim().split("\n").map((line) => line.split(","));
const samples = about.microphones.map((name) => rows.map((row) => Number(row[head.indexOf(name)])));

// sections of second order, as transposed direct form II
for (const [b0, b1, b2, , a1, a2] of stream.high_pass_sections) {
  for (const channel of samples) {
    let [first, second] = [0, 0];
    for (let k = 0; k < channel.length; k++) {
      const value = channel[k];
      const passed = b0 * value + first;
      first = b1 * value - a1 * passed + second;
      second = b2 * value - a2 * passed;
      channel[k] = passed;
    }
  }
}

const session = await InferenceSession.create(model);
for (let end = frame; end <= samples[0].length; end += stream.hop) {
  const heard = Float32Array.from(samples.flatMap((channel) => channel.slice(end - frame, end)));
  if (Math.sqrt(heard.reduce((sum, value) => sum + value * value, 0) / heard.length) < stream.silence) continue;
  const frames = new Tensor("float32", heard, [1, samples.length, frame]);
  const { probability } = await session.run({ frames });
  console.log(end / about.sample_rate, probability.data.indexOf(Math.max(...probability.data)) + 1);
}
