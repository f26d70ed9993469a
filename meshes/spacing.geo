// One-dimensional node spacings.
//
// Spacing: nodes on a line that passes exactly through given positions ("stops"), fine at them
// and growing geometrically away from them.
//
//   in   sp_at[]    stops, ascending; the first and the last are the ends of the line
//        sp_size[]  wanted element size at each stop; sp_any where the stop wants none
//        sp_fine[]  elements of that size on either side of each stop
//        sp_least[] fewest elements in each interval between stops
//        sp_cap     largest element
//        sp_growth  largest ratio of neighbouring elements
//        sp_uniform 1: elements of size sp_cap, as nearly as they fit, a half rounded up (in any
//                   unit); sizes are not looked at
//   out  sp_node[]  node positions
//        sp_stop[]  index of each stop in sp_node[]
//
// The elements at a stop keep their size; what does not fit is taken up by a smaller growth.
// An interval too short for its fine elements is divided evenly.

sp_any = 1e30;

Macro Spacing
  sp_node[] = {sp_at[0]};
  sp_stop[] = {0};
  For sp_k In {0 : #sp_at[] - 2}
    sp_length = sp_at[sp_k + 1] - sp_at[sp_k];
    If (sp_uniform)
      sp_n = Max(sp_least[sp_k], Floor(sp_length / sp_cap + 0.5 + 1e-6));
      sp_n = Max(1, sp_n);
      For sp_i In {1 : sp_n}
        sp_node[] += sp_at[sp_k] + sp_length * sp_i / sp_n;
      EndFor
    Else
      sp_a = sp_size[sp_k];
      sp_b = sp_size[sp_k + 1];
      sp_fa = sp_fine[sp_k];
      sp_fb = sp_fine[sp_k + 1];

      // How many elements grow from either end: always add the smaller of the two next ones.
      sp_na = 0;
      sp_nb = 0;
      sp_sum = 0;
      For sp_i In {1 : 1000}
        If (sp_sum < sp_length * (1 - 1e-9) || sp_na + sp_nb < sp_least[sp_k])
          sp_next_a = sp_a * sp_growth ^ Max(0, sp_na + 1 - sp_fa);
          sp_next_b = sp_b * sp_growth ^ Max(0, sp_nb + 1 - sp_fb);
          If (sp_next_a <= sp_next_b * (1 + 1e-9))
            sp_na += 1;
          Else
            sp_nb += 1;
          EndIf
          sp_sum += Min(sp_cap, Min(sp_next_a, sp_next_b));
        EndIf
      EndFor

      // The growth with which they fill the interval, by bisection.
      sp_low = 1;
      sp_high = sp_growth;
      For sp_step In {1 : 50}
        sp_ratio = (sp_low + sp_high) / 2;
        sp_sum = 0;
        For sp_i In {1 : sp_na}
          sp_sum += Min(sp_cap, sp_a * sp_ratio ^ Max(0, sp_i - sp_fa));
        EndFor
        For sp_i In {1 : sp_nb}
          sp_sum += Min(sp_cap, sp_b * sp_ratio ^ Max(0, sp_i - sp_fb));
        EndFor
        If (sp_sum > sp_length)
          sp_high = sp_ratio;
        Else
          sp_low = sp_ratio;
        EndIf
      EndFor

      // Scaled by length/sum, which differs from 1 only where even equal elements are too long.
      sp_x = 0;
      For sp_i In {1 : sp_na}
        sp_x += Min(sp_cap, sp_a * sp_ratio ^ Max(0, sp_i - sp_fa));
        sp_node[] += sp_at[sp_k] + sp_length * sp_x / sp_sum;
      EndFor
      For sp_i In {sp_nb : 1 : -1}
        sp_x += Min(sp_cap, sp_b * sp_ratio ^ Max(0, sp_i - sp_fb));
        sp_node[] += sp_at[sp_k] + sp_length * sp_x / sp_sum;
      EndFor
    EndIf
    // The stop itself, free of rounding.
    sp_node[#sp_node[] - 1] = sp_at[sp_k + 1];
    sp_stop[] += #sp_node[] - 1;
  EndFor
Return

// End: the stops of an end of a roller, on the roller and on the plates that it meets.
//
//   in   en_at      where the end is, on either side of zero: if it is negative other stops come after it
//        en_radius  radius of the rounded end, which begins at a stop; 0: sharp
//        EdgeReach  distance of a stop from a sharp end, or from where a fillet begins; 0: none
//        EndSize    element size at a sharp end and where a fillet begins
//   out  appended to sp_at[], sp_size[], sp_fine[] and sp_least[]

Macro End
  // From inside to the end.
  en_in[] = {};
  en_size[] = {};
  If (EdgeReach > 0)
    en_in[] += en_radius + EdgeReach;
    en_size[] += Max(EndSize, EdgeReach / 3);
  EndIf
  If (en_radius > 0)
    en_in[] += en_radius;
    en_size[] += EndSize;
  EndIf
  en_in[] += 0;
  en_size[] += en_radius > 0 ? sp_any : EndSize;
  For en_i In {0 : #en_in[] - 1}
    en_k = en_at < 0 ? #en_in[] - 1 - en_i : en_i;
    sp_at[] += en_at < 0 ? en_at + en_in[en_k] : en_at - en_in[en_k];
    sp_size[] += en_size[en_k];
    sp_fine[] += 1;
    If (en_i > 0)
      sp_least[] += 1;
    EndIf
  EndFor
Return
