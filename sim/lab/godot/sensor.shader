// The image of a camera from subframes of a pinhole: radial distortion, a rolling exposure of several subframes, noise.
// Each subframe is blended into what is there, so that a row is the mean of the subframes in its exposure.
shader_type canvas_item;
render_mode unshaded, blend_mix;

uniform vec2 size_px;           // of the image
uniform float focal_px;
uniform vec2 centre_px;         // 0 is the middle of the first pixel
uniform float k1;
uniform float k2;
uniform vec2 pinhole_px;        // size of the subframe, whose centre is in its middle
uniform float pinhole_focal_px;
uniform vec2 jitter_px;         // of this subframe, against steps
uniform float index;            // of this subframe, from 0
uniform float in_exposure;      // subframes of a row
uniform float last_row_begins;  // index of its first subframe; 0: all rows at once
uniform float noise;            // standard deviation of a subframe's noise, of 1
uniform float seed;

float random(vec2 p) {
	vec3 q = fract(vec3(p.xyx) * 0.1031);
	q += dot(q, q.yzx + 33.33);
	return fract((q.x + q.y) * q.z);
}

void fragment() {
	vec2 pixel = UV * size_px;
	float first = ceil(pixel.y / size_px.y * last_row_begins - 0.5);
	if (index < first - 0.25 || index > first + in_exposure - 0.75)
		discard;
	// OpenCV: distorted = ray (1 + k1 r^2 + k2 r^4). The ray of a distorted pixel by Newton's method on its length.
	vec2 distorted = (pixel - 0.5 + jitter_px - centre_px) / focal_px;
	float wanted = length(distorted);
	float r = wanted;
	for (int i = 0; i < 4; i++) {
		float r2 = r * r;
		r -= (r * (1.0 + r2 * (k1 + r2 * k2)) - wanted) / (1.0 + r2 * (3.0 * k1 + 5.0 * k2 * r2));
	}
	vec2 ray = wanted > 0.0 ? distorted * (r / wanted) : distorted;
	vec3 shown = texture(TEXTURE, (ray * pinhole_focal_px + pinhole_px / 2.0) / pinhole_px).rgb;
	// Darker towards the corners, as by any lens.
	shown /= (1.0 + 0.5 * r * r);
	vec2 at = floor(pixel) + vec2(seed * 17.0, seed * 29.0);
	float sum = random(at) + random(at + 1021.0) + random(at + 2053.0) - 1.5;
	COLOR = vec4(shown + noise * 2.0 * sum, 1.0 / (index - first + 1.0));
}
