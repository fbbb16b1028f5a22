// The space in which distances are measured: texture coordinates u and v, and h times metric_height. Lengths along a ray
// in it are what sphere tracing compares with them, so that any metric_height is right at any height scale.

const float stored_steps = 65535.0;

// Of a distance as a fraction of metric_height, the longest that there is: straight down. Rounded down to what 16 bits
// store, so that no step is longer than the distance.
float round_down(float fraction) {
    float stored = floor(clamp(fraction, 0.0, 1.0) * stored_steps);
    if (stored / stored_steps > fraction) stored = max(stored - 1.0, 0.0);
    return stored / stored_steps;
}

// Of the slice's centres.
float slice_height(int slice) {
    return (float(slice) + 0.5) / float(slices);
}

// How many cells to look at on either side, once a distance is known that the others must undercut. Farther than half the
// map a nearer repeat of the same cell has been seen.
int search_reach(float distance, float texel, int texels) {
    return min(int(ceil(distance / texel)) + 1, texels / 2 + 1);
}
