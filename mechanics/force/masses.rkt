#lang racket/base
;; Masses: one for a particle alone, a list for several.  Where a position is an angle,
;; the mass is a moment of inertia.

(require "../error/complain.rkt" "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         (only-in "../value/structure.rkt" list->up s:length structure->list))

(provide check-masses check-masses-fit times-masses masses->datum)

(define (check-masses who masses)
  (unless (or (scalar? masses)
              (and (pair? masses) (list? masses) (andmap scalar? masses)))
    (complain-of-argument who "a mass, or a list of the masses of several particles" masses
                          (cond [(tuple? masses)
                                 (format "\n  as a list: ~a"
                                         (cons 'list (cdr (value->datum (adopt masses)))))]
                                [(procedure? masses) "\n  masses come first, then the positions r"]
                                [else ""]))))

;; One mass, one particle; n of them, n particles.
(define (check-masses-fit who masses positions)
  (cond [(list? masses)
         (define n (length masses))
         (unless (and (tuple? positions) (= n (s:length positions)))
           (raise-wrong-count who n positions))]
        [(several-particles? positions)
         (complain who
                   (string-append "there is one mass, but the positions are those of ~a"
                                  "\n  positions: ~a"
                                  "\n  several masses are a list: (list m1 m2 ...)")
                   (counted (s:length positions) "particle") (value->text positions))]))

(define (raise-wrong-count who n positions)
  (complain who "there ~a, but the positions are those of ~a\n  positions: ~a~a"
            (if (= n 1) "is 1 mass in the list" (format "are ~a masses" n))
            (counted (s:length positions) "particle")
            (value->text positions)
            (if (= n 1) "\n  the mass of a particle alone stands by itself, in no list" "")))

(define (several-particles? positions)
  (and (tuple? positions) (ormap tuple? (structure->list positions))))

;; xs : a tuple like the positions -> the same with the part of each particle times its mass
(define (times-masses masses xs)
  (if (list? masses)
      (structure-map2 g:* (list->up masses) (adopt xs))
      (g:* masses xs)))

(define (masses->datum masses)
  (if (list? masses) (cons 'list (value->datum masses)) (value->datum masses)))
