;; Mutants that no behaviour tells from the library: (file "the line as it was" "as it is" "reason")

("algebra/polynomial/sparse-gcd.rkt"
 "(charge! R (* cost (skeleton-count s)))"
 "(charge! R (+ cost (skeleton-count s)))"
 "an estimate of work: it tells when dense methods take over, not what comes out")
("algebra/polynomial/gcd.rkt"
 "(and (null? others) (equal? bounds (degrees R p kept))))"
 "(or (null? others) (equal? bounds (degrees R p kept))))"
 "a division in vain is tried; one that goes up is of the gcd all the same")
("algebra/kernel/roots.rkt"
 "(modulo (+ (if (negative? c) 1 0)"
 "(modulo (- (if (negative? c) 1 0)"
 "modulo 2 a sum is a difference")
