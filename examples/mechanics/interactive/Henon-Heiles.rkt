#lang mechanics
;; Sections of the motion of Hénon and Heiles at energies up to 1/6, at which a star may leave:
;; curves at low energies, islands and then one sea of points at high ones.

(require mechanics/plot mechanics/book)
(provide interaction)

(define (section-map E) (HHmap E 0.1 1e-8 1e-10))

(define starts (list (up 0. 0.1) (up 0.1 0.) (up 0.3 0.) (up -0.2 0.) (up 0. 0.3)))

;; The starts for which there is energy
(define (allowed E)
  (filter (lambda (p) (section->state E (ref p 0) (ref p 1))) starts))

(define interaction
  (interact ([E 0.02 0.16 #:step 0.01 #:start 0.08])
    (define f (frame -0.5 1 -0.6 0.6 #:x-label "y" #:y-label "p_y"))
    (explore-map f (section-map E) 100 #:starts (allowed E) #:size 1.5)))
interaction

(module+ test
  (require rackunit)
  (test-case "at a low energy orbits are regular; at the highest there is energy for every start"
    (check-true (rotation-regular? (rotation-number (section-map 1/12) (up 0.1 0.) 200
                                                    #:about (up 0.2 0.))))
    (check-equal? (length (allowed 0.16)) (length starts))
    (check-equal? (allowed 0.02) (list (up 0. 0.1) (up 0.1 0.)))))
